(assert (! (is_turn travel) :named mine))
