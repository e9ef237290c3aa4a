//! Integers of 128 bits in the C: structs of two words of 64 bits, since C99 has no such integer.
//!
//! In Rust they are Rust's own. The functions here are their operators, conversions and methods in the C. A name is that
//! of Rust's method, or of the operator's trait. Operators that may fault are expanded: a check at the author's line,
//! then a function that cannot fault.

pub mod i128;
mod methods;
// `!(rest < tried)` is the condition as the C has it, and holds for a NaN.
#[allow(clippy::neg_cmp_op_on_partial_ord)]
pub mod u128;
