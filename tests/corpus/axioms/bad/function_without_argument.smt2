(assert (! (forall ((q DState)) (=> (ends q) (= place (place q)))) :named mine))
