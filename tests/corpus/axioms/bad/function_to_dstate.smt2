(declare-fun turned (DState) DState)
