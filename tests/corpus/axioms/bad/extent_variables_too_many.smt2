(set-info :extent (end ((q DState) (r DState) (s DState) (t DState) (u DState)) q r s t u))
