(set-info :extent (end ((q DState)) :where (room q) q))
