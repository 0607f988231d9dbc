(declare-const raining Bool)
