(set-info :minimise (path place))
(set-info :minimise (path place))
