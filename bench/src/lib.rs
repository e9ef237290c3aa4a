//! Measurements: ratios within one run, medians with spread, results in `bench/results/`.
//!
//! | module | what it measures |
//! |---|---|
//! | [`check_cost`] | what the attributes add to `cargo check` of a model |
//! | [`generation`] | how long a generation takes, by the number of functions |
//! | [`kernels`] | generated kernels against handwritten C and the libraries |
//! | [`rebuild`] | what the attributes add to a rebuild of the corpus |
//!

pub mod check_cost;
pub mod generation;
pub mod kernels;
pub mod rebuild;
