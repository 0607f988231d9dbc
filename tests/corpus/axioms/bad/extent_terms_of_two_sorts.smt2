(set-info :extent (end ((q DState)) (place q) (along q)))
