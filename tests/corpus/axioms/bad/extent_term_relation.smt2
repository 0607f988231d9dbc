(set-info :extent (end ((q DState)) (ends q)))
