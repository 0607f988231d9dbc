; transitive   [mine]
(declare-const home Place)
