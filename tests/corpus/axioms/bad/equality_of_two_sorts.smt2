(assert (! (forall ((q DState)) (=> (ends q) (= (place q) (along q)))) :named mine))
