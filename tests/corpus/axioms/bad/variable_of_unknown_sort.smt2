(assert (! (forall ((q Room)) (=> (ends q) false)) :named mine))
