(declare-const home Room)
