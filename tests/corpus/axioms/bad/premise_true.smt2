(assert (! (forall ((q DState)) (=> true (ends q))) :named mine))
