(assert (! (forall ((q DState) (r DState)) (=> (opposite q r) (or (order q r) (order r q)))) :named axiom.choice))
(set-info :extent (end ((q DState)) q))
(set-info :minimise (path end))
