(set-info :extent (end ((q DState)) q))
(set-info :extent (end ((q DState)) (place q)))
