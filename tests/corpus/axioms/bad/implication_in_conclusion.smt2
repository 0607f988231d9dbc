(assert (! (forall ((q DState)) (=> (ends q) (=> (ends q) false))) :named mine))
