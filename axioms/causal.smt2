; The causal level: what actions lead to, what is seen.
;
; A dstate is the robot at a place, facing along a directed path. Dstates, actions and views have
; unique names: two constants are never equal.
;
; Labels begin with `axiom.`, which is not part of the name: in SMT-LIB a label is a symbol like any
; other, and some axioms are called what a relation is.

(declare-sort DState 0)
(declare-sort Action 0)
(declare-sort View 0)

(declare-const travel Action)
(declare-const turn_around Action)
(declare-const turn_clockwise Action)  ; to the next arm

(declare-fun leads (DState Action DState) Bool)  ; the schema <q, a, r>: a, done at q, leads to r
(declare-fun sees (DState View) Bool)            ; at q the view is v

; deterministic                                                        [BMK10, §3.2] [RK04]
; One dstate and one action have one result.
;   leads(q, a, r) ∧ leads(q, a, s)  →  r = s
(assert (! (forall ((q DState) (a Action) (r DState) (s DState))
               (=> (and (leads q a r) (leads q a s)) (= r s)))
         :named axiom.deterministic))

; view                                                                 [BMK10, §3.2] [RK04]
; Equal dstates have equal views.
;   sees(q, v) ∧ sees(q, w)  →  v = w
(assert (! (forall ((q DState) (v View) (w View))
               (=> (and (sees q v) (sees q w)) (= v w)))
         :named axiom.view))

; reversible                                                           [RK04]
; If travel leads from q to r, travel leads from r turned around to q turned around.
;   leads(q, travel, r) ∧ leads(q, turn_around, q') ∧ leads(r, turn_around, r')
;     →  leads(r', travel, q')
(assert (! (forall ((q DState) (r DState) (q1 DState) (r1 DState))
               (=> (and (leads q travel r) (leads q turn_around q1) (leads r turn_around r1))
                   (leads r1 travel q1)))
         :named axiom.reversible))
