(declare-fun beside (Place Place))
