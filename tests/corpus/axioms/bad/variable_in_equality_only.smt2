(assert (! (forall ((q DState) (r DState)) (=> (and (ends q) (= q r)) false)) :named mine))
