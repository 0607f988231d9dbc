(assert (! (forall ((q DState) (r DState)) (=> (ends q) (next q r))) :named mine))
