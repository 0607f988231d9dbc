(assert (! (forall ((q DState)) (=> (ends q) (= q))) :named mine))
