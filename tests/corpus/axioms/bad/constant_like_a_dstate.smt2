(declare-const d3_1 DState)
