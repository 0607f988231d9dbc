; The local topological level: the star of a place, bound to dstates.
;
; Each arm of a place is one dstate and each dstate one arm: an arm is named by its dstate.

(declare-fun next (DState DState) Bool)       ; r is the next arm clockwise after q
(declare-fun opposite (DState DState) Bool)   ; the two directions of one local-path
(declare-fun ends (DState) Bool)              ; α = 0: the path ends here

; star                                                                 [BMK10, §5.1.2]
; Next is a clockwise circle over the arms of a place, and turning goes round it.
;   next(q, r) ∧ next(q, s) ∧ next(t, r)  →  r = s ∧ q = t ∧ leads(q, turn_clockwise, r)
(assert (! (forall ((q DState) (r DState) (s DState) (t DState))
               (=> (and (next q r) (next q s) (next t r))
                   (and (= r s) (= q t) (leads q turn_clockwise r))))
         :named axiom.star))

; path_end                                                             [BMK10, §5.1.2]
; Where α = 0 nothing follows on that directed path.
;   ends(q)  →  ¬order(q, r)
(assert (! (forall ((q DState) (r DState))
               (=> (and (ends q) (order q r)) false))
         :named axiom.path_end))

; star_binding                                                         [BMK10, §6.1]
; Opposite arms are the two directions of one path: they come in pairs, and turning around at one
; faces the other.
;   opposite(q, r) ∧ opposite(q, s) ∧ opposite(t, r)
;     →  r = s ∧ q = t ∧ opposite(r, q) ∧ leads(q, turn_around, r)
(assert (! (forall ((q DState) (r DState) (s DState) (t DState))
               (=> (and (opposite q r) (opposite q s) (opposite t r))
                   (and (= r s) (= q t) (opposite r q) (leads q turn_around r))))
         :named axiom.star_binding))
