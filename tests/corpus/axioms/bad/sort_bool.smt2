(declare-sort Bool 0)
