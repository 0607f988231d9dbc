(assert (! (forall ((q DState) (r DState)) (=> (and (ends q) (not (ends r))) (next q r))) :named mine))
