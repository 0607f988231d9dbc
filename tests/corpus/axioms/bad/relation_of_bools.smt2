(declare-fun both (Bool Bool) Bool)
