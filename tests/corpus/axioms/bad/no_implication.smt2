(assert (! (forall ((q DState)) (ends q)) :named mine))
