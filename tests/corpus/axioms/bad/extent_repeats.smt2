(set-info :extent (end ((q DState)) q))
(set-info :minimise (end end))
