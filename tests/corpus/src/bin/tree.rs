//! Prints the tree of every program in this package.

bessemer::print_tree!(corpus);
