//! Tables and split constants of the elementary functions.
//!
//! The modules below are written by `dsl/coefficients/tables.py`.

#![allow(clippy::approx_constant)]

mod angles;
mod decimal;
mod finer;
mod logarithms;
mod narrow;
mod powers;

pub use angles::*;
pub use decimal::*;
pub use finer::*;
pub use logarithms::*;
pub use narrow::*;
pub use powers::*;
