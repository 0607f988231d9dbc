(set-info :extent path)
