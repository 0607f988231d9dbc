(declare-const home Place)
(declare-const home Place)
