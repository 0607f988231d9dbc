(assert (! (forall ((v View)) (=> (ends v) false)) :named mine))
