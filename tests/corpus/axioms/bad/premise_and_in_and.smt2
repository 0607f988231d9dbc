(assert (! (forall ((q DState) (r DState)) (=> (and (and (next q r) (ends q)) (ends r)) false)) :named mine))
