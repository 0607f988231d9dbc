(assert (! (forall ((q DState)) (=> (ends q) false)) :pattern mine))
