(set-info :extent (end ((q DState) (r DState)) :where (ends q) q))
