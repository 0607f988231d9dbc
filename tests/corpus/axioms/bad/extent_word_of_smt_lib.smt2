(set-info :extent (and ((q DState)) q))
