(assert (! (forall ((q DState)) (=> (next q r) false)) :named mine))
