; one_segment                                                          [optional]
; Two places are joined by at most one segment.
;   leads(q, travel, r) ∧ leads(s, travel, t) ∧ place(q) = place(s) ∧ place(r) = place(t)  →  q = s
(assert (! (forall ((q DState) (r DState) (s DState) (t DState))
               (=> (and (leads q travel r) (leads s travel t)
                        (= (place q) (place s)) (= (place r) (place t)))
                   (= q s)))
         :named axiom.one_segment))
