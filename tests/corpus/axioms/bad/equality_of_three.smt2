(assert (! (forall ((q DState)) (=> (ends q) (= q q q))) :named mine))
