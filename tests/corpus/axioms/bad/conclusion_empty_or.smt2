(assert (! (forall ((q DState)) (=> (ends q) (or))) :named mine))
