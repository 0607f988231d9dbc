(assert (! (forall ((q Bool)) (=> (ends q) false)) :named mine))
