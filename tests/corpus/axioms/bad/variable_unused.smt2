(assert (! (forall ((q DState) (v View)) (=> (ends q) false)) :named mine))
