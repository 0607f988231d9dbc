(assert (! (forall ((q DState)) (=> (leads q (travel q) q) false)) :named mine))
