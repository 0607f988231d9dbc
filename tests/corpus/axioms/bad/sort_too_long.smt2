(declare-sort Room 0 0)
