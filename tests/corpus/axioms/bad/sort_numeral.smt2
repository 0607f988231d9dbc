(declare-sort 7 0)
