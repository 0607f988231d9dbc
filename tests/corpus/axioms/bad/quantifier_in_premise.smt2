(assert (! (forall ((q DState)) (=> (and (ends q) (forall ((r DState)) (next q r))) false)) :named mine))
