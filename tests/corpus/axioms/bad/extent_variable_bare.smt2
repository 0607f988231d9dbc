(set-info :extent (end (q) q))
