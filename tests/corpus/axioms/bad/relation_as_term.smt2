(assert (! (forall ((q DState)) (=> (ends (next q q)) false)) :named mine))
