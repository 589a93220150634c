namespace varimarch {}
