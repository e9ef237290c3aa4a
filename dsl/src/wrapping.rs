//! Numbers whose arithmetic wraps: the C of core's `Wrapping`, a struct of one number.
//!
//! Each operator is that of the number, wrapped to the type's width.

use core::num::Wrapping as Native;

use crate::Plain;
use crate::prelude::*;

/// `core::num::Wrapping` in the C.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Wrapping<T>(pub T);

#[diagnostic::do_not_recommend]
impl<T: Plain> Plain for Native<T> {
    const WORDS: usize = T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.0.store(out);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        Native(T::load(next))
    }
}

/// The sum.
#[function]
#[inline]
pub fn sum<T: Integer>(one: Native<T>, other: Native<T>) -> Native<T> {
    Native(one.0.wrapping_add(other.0))
}

/// The difference.
#[function]
#[inline]
pub fn difference<T: Integer>(one: Native<T>, other: Native<T>) -> Native<T> {
    Native(one.0.wrapping_sub(other.0))
}

/// The product.
#[function]
#[inline]
pub fn product<T: Integer>(one: Native<T>, other: Native<T>) -> Native<T> {
    Native(one.0.wrapping_mul(other.0))
}

/// The negative of a number.
#[function]
#[inline]
pub fn negative<T: Integer>(one: Native<T>) -> Native<T> {
    Native(T::ZERO.wrapping_sub(one.0))
}

/// Adds to a number.
#[function]
#[inline]
pub fn add<T: Integer>(one: &mut Native<T>, other: Native<T>) {
    one.0 = one.0.wrapping_add(other.0);
}

/// Subtracts from a number.
#[function]
#[inline]
pub fn subtract<T: Integer>(one: &mut Native<T>, other: Native<T>) {
    one.0 = one.0.wrapping_sub(other.0);
}

/// Multiplies a number.
#[function]
#[inline]
pub fn multiply<T: Integer>(one: &mut Native<T>, other: Native<T>) {
    one.0 = one.0.wrapping_mul(other.0);
}

/// The bits that are 1 in both numbers.
#[function]
#[inline]
pub fn both<T: Integer>(one: Native<T>, other: Native<T>) -> Native<T> {
    Native(one.0 & other.0)
}

/// The bits that are 1 in at least one of the numbers.
#[function]
#[inline]
pub fn either<T: Integer>(one: Native<T>, other: Native<T>) -> Native<T> {
    Native(one.0 | other.0)
}

/// The bits in which the two differ.
#[function]
#[inline]
pub fn differing<T: Integer>(one: Native<T>, other: Native<T>) -> Native<T> {
    Native(one.0 ^ other.0)
}
