(declare-fun = (Place Place) Bool)
