; yours   [own]
(set-info :extent (mine ((q DState)) q))
