(set-info :extent (end ((q DState)) (room q)))
