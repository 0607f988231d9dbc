(declare-sort Räume 0)
