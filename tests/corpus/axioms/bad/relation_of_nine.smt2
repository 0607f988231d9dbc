(declare-fun nine (Place Place Place Place Place Place Place Place Place) Bool)
