(assert (! (forall ((q DState)) (=> (let ((r q)) (ends r)) false)) :named mine))
