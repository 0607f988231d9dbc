(assert (! (forall ((q DState)) (=> (ends q) false)) :named transitive))
