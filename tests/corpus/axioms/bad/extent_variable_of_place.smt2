(set-info :extent (end ((p Place)) p))
