(assert (! (exists ((q DState)) (=> (ends q) false)) :named mine))
