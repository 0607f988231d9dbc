(assert (! (forall ((q DState)) (=> (place q) false)) :named mine))
