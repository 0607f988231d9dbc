; The preference: prioritised circumscription. Minimise the extents named last, the first before the
; second.                                                                 [RK04] [BMK10, §3.3]
;
; An extent is the number of classes of the values of its terms. The variables stand for all dstates,
; or for those for which what follows `:where` holds; the terms of one instance are in one class.
; What holds and what is equal is the least that the axioms force.

; path                                                                 [RK04] [BMK10, §3.3]
; A directed path and its opposite are one path.
;   |{along(q), opp(along(q))}|, over all q
(set-info :extent (path ((q DState)) (along q) (opp (along q))))

; place                                                                [RK04] [BMK10, §3.3]
; Each place counts.
;   |{place(q)}|, over all q
(set-info :extent (place ((q DState)) (place q)))

; segment                                                              [BMK10]
; A travel and its way back are one segment, of two gateways.
;   |{q, s}|, over all q, r, s with  leads(q, travel, r) ∧ leads(r, turn_around, s)
(set-info :extent (segment ((q DState) (r DState) (s DState))
                   :where (and (leads q travel r) (leads r turn_around s)) q s))

(set-info :minimise (path place))
