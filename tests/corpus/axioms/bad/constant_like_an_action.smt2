(declare-const a4 Action)
