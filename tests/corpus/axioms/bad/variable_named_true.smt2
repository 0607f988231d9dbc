(assert (! (forall ((true DState)) (=> (ends true) false)) :named mine))
