//! Tables and split constants of the elementary functions.
//!
//! The modules below are written by `dsl/coefficients/tables.py`.

#![allow(clippy::approx_constant)]

mod angles;
mod powers;

pub use angles::*;
pub use powers::*;
