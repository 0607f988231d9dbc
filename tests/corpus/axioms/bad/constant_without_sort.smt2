(declare-const home)
