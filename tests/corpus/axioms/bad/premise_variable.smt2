(assert (! (forall ((q DState)) (=> q (ends q))) :named mine))
