(set-info :extend (end ((q DState)) q))
