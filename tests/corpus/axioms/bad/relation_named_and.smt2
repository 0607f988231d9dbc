(declare-fun and (Place Place) Bool)
