(set-info :extent (end ((q DState)) q) (start ((q DState)) q))
