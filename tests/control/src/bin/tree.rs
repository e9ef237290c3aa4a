//! Prints the tree of the programs.

bessemer::print_tree!(control);
