; The preference: prioritised circumscription. Minimise the extent of each predicate, the first before
; the second. Known: path, place, segment.                             [RK04] [BMK10, §3.3]

(set-info :minimise (path place))
