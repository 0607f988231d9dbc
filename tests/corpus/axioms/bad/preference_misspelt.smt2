(set-info :minimize (path place))
