//! The solvers of `cargo xtask bench --only qp`, as a user names them: 40 inputs of a horizon, each with limits.
#![no_std]

use bessemer::prelude::*;

/// The active set.
#[component]
pub type Exact = bessemer_blocks::ActiveSet<f64, 40, 40, 80>;

/// The alternating directions.
#[component]
pub type Split = bessemer_blocks::Admm<f64, 40, 40, 0, 0, 1200>;
