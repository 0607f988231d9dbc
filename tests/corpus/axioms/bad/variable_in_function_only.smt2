(assert (! (forall ((q DState)) (=> (on (along q) (place q)) false)) :named mine))
