(set-info :extent (end ((q DState)) :when (ends q) q))
