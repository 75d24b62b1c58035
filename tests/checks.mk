# checks of the tree as a whole
