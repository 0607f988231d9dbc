(declare-fun beside (Place Room) Bool)
