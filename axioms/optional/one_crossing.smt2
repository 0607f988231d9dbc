; one_crossing                                                         [optional]
; Two paths meet at most once: what comes before r's place, at q's place, is on one path only.
;   order(q, r) ∧ order(s, t) ∧ place(q) = place(s) ∧ place(r) = place(t)  →  q = s
(assert (! (forall ((q DState) (r DState) (s DState) (t DState))
               (=> (and (order q r) (order s t)
                        (= (place q) (place s)) (= (place r) (place t)))
                   (= q s)))
         :named axiom.one_crossing))
