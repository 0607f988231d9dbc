(assert (! (forall ((q DState)) (=> (and (ends q) (not (not (ends q)))) false)) :named mine))
