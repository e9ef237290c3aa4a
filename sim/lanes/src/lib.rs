//! Values of eight runs at once, in vectors.
//!
//! A *lane* is one run. Each operation computes, in each lane, the bits that Rust computes for one value: a sum is
//! rounded once, a product is never fused with a sum. Lanes in which a branch is not taken compute, too, and their
//! values are never stored: each write has a [`Mask`]. So no operation panics, whatever the values.
//!
//! `bessemer-vectors` emits code that computes with these types. Knows no component and no control flow.

mod angle;
mod byte;
mod linear;
mod mask;
mod number;
mod real;
mod single;
mod store;
mod whole;

pub use angle::sin_cos;
pub use byte::Byte;
pub use linear::{
    add, component_div, component_mul, cross, dot, neg, norm, norm_squared, product, scale, sub,
    tr_mul, tr_product, transpose, unscale,
};
pub use mask::Mask;
pub use number::Number;
pub use real::Real;
pub use single::Single;
pub use store::{Lanes, and, each, index, or, pick, table, table_at};
pub use whole::Whole;

/// Number of lanes.
pub const LANES: usize = 8;

#[cfg(test)]
mod tests;
