(declare-fun beside (Place Place) Bool)
(declare-fun beside (Place) Bool)
