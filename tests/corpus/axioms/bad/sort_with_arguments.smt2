(declare-sort Set 1)
