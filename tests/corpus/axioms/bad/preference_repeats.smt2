(set-info :minimise (path place path))
