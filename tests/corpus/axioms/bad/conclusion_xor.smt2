(assert (! (forall ((q DState)) (=> (ends q) (xor (ends q) (ends q)))) :named mine))
