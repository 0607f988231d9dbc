(assert
  (! (forall

