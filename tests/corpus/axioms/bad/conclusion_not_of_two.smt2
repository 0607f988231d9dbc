(assert (! (forall ((q DState)) (=> (ends q) (not (ends q) (ends q)))) :named mine))
