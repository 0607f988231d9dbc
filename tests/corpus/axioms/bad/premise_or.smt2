(assert (! (forall ((q DState) (r DState)) (=> (or (next q r) (next r q)) false)) :named mine))
