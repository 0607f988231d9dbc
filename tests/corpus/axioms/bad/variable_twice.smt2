(assert (! (forall ((q DState) (q DState)) (=> (ends q) false)) :named mine))
