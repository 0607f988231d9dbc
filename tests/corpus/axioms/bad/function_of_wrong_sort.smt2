(assert (! (forall ((q DState)) (=> (ends q) (= (opp (place q)) (along q)))) :named mine))
