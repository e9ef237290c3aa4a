//! Measurements: ratios within one run, medians with spread, results in `bench/results/`.
//!
//! | module | what it measures |
//! |---|---|
//! | [`check_cost`] | what the attributes add to `cargo check` of a model |
//! | [`generation`] | how long a generation takes, by the number of functions |
//! | [`rebuild`] | what the attributes add to a rebuild of the corpus |
//!
//! The comparison of generated with handwritten C comes with the linear algebra.

pub mod check_cost;
pub mod generation;
pub mod rebuild;
