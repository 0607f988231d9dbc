; a comment

(declare-sort Room 1)
