(set-info :extent (end ((q DState)) (opp (place q))))
