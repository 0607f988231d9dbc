(declare-fun beside Place Bool)
