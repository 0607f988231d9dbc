(set-info :extent (end ((q DState) (q DState)) q))
