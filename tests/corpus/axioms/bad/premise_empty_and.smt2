(assert (! (forall ((q DState)) (=> (and) (ends q))) :named mine))
