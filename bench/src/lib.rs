//! Measurements: ratios within one run, medians with spread, results in `bench/results/`.
//!
//! | module | what it measures |
//! |---|---|
//! | [`check_cost`] | what the attributes add to `cargo check` of a model |
//!
//! The comparison of generated with handwritten C comes with the linear algebra.

pub mod check_cost;
