(assert (! (forall ((q DState) (r DState)) (=> (beside q r) false)) :named mine))
