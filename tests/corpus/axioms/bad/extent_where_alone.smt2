(set-info :extent (end ((q DState)) :where (ends q)))
