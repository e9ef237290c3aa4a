//! Tables and split constants of the elementary functions.
//!
//! The modules of this directory are written by `dsl/coefficients/tables.py`.

#![allow(clippy::approx_constant)]

mod angles;
mod decimal;
mod fast;
mod finer;
mod logarithms;
mod narrow;
mod powers;

pub(crate) use angles::*;
pub(crate) use decimal::*;
pub(crate) use fast::*;
pub(crate) use finer::*;
pub(crate) use logarithms::*;
pub(crate) use narrow::*;
pub(crate) use powers::*;
