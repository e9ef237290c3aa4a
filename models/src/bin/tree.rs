//! Prints the tree of every model in this package: run by `cargo xtask gen`.

bessemer::print_tree!(models);
