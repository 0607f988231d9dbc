(assert (! (forall q (=> (ends q) false)) :named mine))
