(set-info :minimise path)
