(assert (! (forall ((q DState)) (=> (ends q q) false)) :named mine))
