(set-info :source "a;b")
