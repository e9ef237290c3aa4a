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

/// Returns the quotient.
///
/// # Panics
/// For a divisor of 0.
#[function]
#[inline]
pub fn quotient<T: Integer>(one: Native<T>, other: Native<T>) -> Native<T> {
    Native(one.0.wrapping_div(other.0))
}

/// Returns the bits that a number does not have.
#[function]
#[inline]
pub fn opposite<T: Integer>(one: Native<T>) -> Native<T> {
    // All bits, of a number with a sign or without.
    Native(one.0 ^ T::ZERO.wrapping_sub(T::ONE))
}

/// Moves the bits up, modulo the width.
#[function]
#[inline]
pub fn up<T: Integer>(one: Native<T>, bits: usize) -> Native<T> {
    Native(one.0.wrapping_shl(bits as u32))
}

/// Moves the bits down, modulo the width; a sign is kept.
#[function]
#[inline]
pub fn down<T: Integer>(one: Native<T>, bits: usize) -> Native<T> {
    Native(one.0.wrapping_shr(bits as u32))
}

/// Divides a number.
///
/// # Panics
/// For a divisor of 0.
#[function]
#[inline]
pub fn divide<T: Integer>(one: &mut Native<T>, other: Native<T>) {
    one.0 = one.0.wrapping_div(other.0);
}

/// Keeps the bits that the other has, too.
#[function]
#[inline]
pub fn keep<T: Integer>(one: &mut Native<T>, other: Native<T>) {
    one.0 = one.0 & other.0;
}

/// Sets the bits of the other.
#[function]
#[inline]
pub fn set<T: Integer>(one: &mut Native<T>, other: Native<T>) {
    one.0 = one.0 | other.0;
}

/// Flips the bits of the other.
#[function]
#[inline]
pub fn flip<T: Integer>(one: &mut Native<T>, other: Native<T>) {
    one.0 = one.0 ^ other.0;
}

/// Moves the bits of a number up, modulo the width.
#[function]
#[inline]
pub fn move_up<T: Integer>(one: &mut Native<T>, other: usize) {
    one.0 = one.0.wrapping_shl(other as u32);
}

/// Moves the bits of a number down, modulo the width; a sign is kept.
#[function]
#[inline]
pub fn move_down<T: Integer>(one: &mut Native<T>, other: usize) {
    one.0 = one.0.wrapping_shr(other as u32);
}
