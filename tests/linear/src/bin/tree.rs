//! Prints the tree of every function in this package.

bessemer::print_tree!(linear);
