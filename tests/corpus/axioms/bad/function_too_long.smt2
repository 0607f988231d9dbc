(assert (! (forall ((q DState)) (=> (ends q) (= (place q q) (place q)))) :named mine))
