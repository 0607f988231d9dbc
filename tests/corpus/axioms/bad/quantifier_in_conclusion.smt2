(assert (! (forall ((q DState)) (=> (ends q) (exists ((r DState)) (next q r)))) :named mine))
