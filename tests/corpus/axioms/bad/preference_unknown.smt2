(set-info :minimise (path room))
