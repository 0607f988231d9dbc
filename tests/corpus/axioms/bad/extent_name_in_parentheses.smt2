(set-info :extent ((end) ((q DState)) q))
