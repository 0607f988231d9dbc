(declare-sort (Room) 0)
