; The topological level: places, paths, order.
;
; Order is written between dstates: order(q, r) says that, along the directed path both face, the
; place of q comes before the place of r. Equality of directed paths, `on` and `order` are the least
; that the axioms force: every axiom has the form of a Horn clause, so leaving equal what need not be
; equal refutes nothing.

(declare-sort Place 0)
(declare-sort DirectedPath 0)

; at                                                                   [BMK10, (1)] [RK04]
; Each dstate is at exactly one place.
;   ∀ q ∃! p.  at(q, p)
(declare-fun place (DState) Place)

; along                                                                [BMK10, (1)] [RK04]
; Each dstate is along exactly one directed path.
;   ∀ q ∃! π.  along(q, π)
(declare-fun along (DState) DirectedPath)

(declare-fun opp (DirectedPath) DirectedPath)    ; the same path in the other direction
(declare-fun on (DirectedPath Place) Bool)       ; the place is on the path
(declare-fun order (DState DState) Bool)
(declare-fun is_turn (Action) Bool)

; turn                                                                 [BMK10, (2)] [RK04]
; A turn stays at its place.
;   leads(q, a, r) ∧ is_turn(a)  →  place(q) = place(r)
(assert (! (forall ((q DState) (a Action) (r DState))
               (=> (and (leads q a r) (is_turn a)) (= (place q) (place r))))
         :named axiom.turn))

; travel                                                               [BMK10, (3)] [RK04]
; A travel stays on its directed path.
;   leads(q, travel, r)  →  along(q) = along(r)
(assert (! (forall ((q DState) (r DState))
               (=> (leads q travel r) (= (along q) (along r))))
         :named axiom.travel))

; turn_around                                                          [BMK10, (4)] [RK04]
; A turn-around stays on its path, direction reversed.
;   leads(q, turn_around, r)  →  along(r) = opp(along(q))
(assert (! (forall ((q DState) (r DState))
               (=> (leads q turn_around r) (= (along r) (opp (along q)))))
         :named axiom.turn_around))

; on                                                                   [BMK10, (5)] [RK04]
; The place of a dstate is on its path.
;   sees(q, v)  →  on(along(q), place(q))
(assert (! (forall ((q DState) (v View))
               (=> (sees q v) (on (along q) (place q))))
         :named axiom.on))

; order                                                                [BMK10, (6)] [RK04]
; A travel orders its two places along the directed path.
;   leads(q, travel, r)  →  order(q, r)
(assert (! (forall ((q DState) (r DState))
               (=> (leads q travel r) (order q r)))
         :named axiom.order))

; order_on                                                             [BMK10, (7)] [RK04]
; What is ordered is on the path.
;   order(q, r)  →  on(along(q), place(q)) ∧ on(along(q), place(r))
(assert (! (forall ((q DState) (r DState))
               (=> (order q r) (and (on (along q) (place q)) (on (along q) (place r)))))
         :named axiom.order_on))

; irreflexive                                                          [BMK10, (8)] [RK04]
; No place precedes itself: no path meets a place twice or closes on itself.
;   order(q, r)  →  place(q) ≠ place(r)
(assert (! (forall ((q DState) (r DState))
               (=> (order q r) (not (= (place q) (place r)))))
         :named axiom.irreflexive))

; opposite                                                             [BMK10, (9)] [RK04]
; Order along a direction is the reverse of order along the other.
;   order(q, r) ∧ leads(q, turn_around, q') ∧ leads(r, turn_around, r')  →  order(r', q')
(assert (! (forall ((q DState) (r DState) (q1 DState) (r1 DState))
               (=> (and (order q r) (leads q turn_around q1) (leads r turn_around r1))
                   (order r1 q1)))
         :named axiom.opposite))

; transitive                                                           [BMK10, (10)] [RK04]
; Order is transitive.
;   order(q, r) ∧ order(r, s)  →  order(q, s)
(assert (! (forall ((q DState) (r DState) (s DState))
               (=> (and (order q r) (order r s)) (order q s)))
         :named axiom.transitive))
