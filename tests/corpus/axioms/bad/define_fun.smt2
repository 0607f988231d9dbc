(define-fun f ((q DState)) Bool true)
