(assert (! (forall ((q DState)) (=> (next q) false)) :named mine))
