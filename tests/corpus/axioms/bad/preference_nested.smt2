(set-info :minimise (path (place)))
