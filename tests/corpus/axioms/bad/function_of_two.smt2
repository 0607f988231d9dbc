(declare-fun midway (Place Place) Place)
