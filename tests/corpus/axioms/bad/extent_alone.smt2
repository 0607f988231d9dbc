(set-info :extent)
