(declare-const v12 Place)
