(assert (! (forall ((travel DState)) (=> (ends travel) false)) :named mine))
