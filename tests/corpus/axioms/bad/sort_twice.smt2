(declare-sort Place 0)
