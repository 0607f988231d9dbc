(set-info :extent (end ((q DState)) :where (or (ends q) (ends q)) q))
