(declare-fun seen (DState) View)
