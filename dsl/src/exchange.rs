//! `core::mem::swap` and `replace` in the DSL: a call is replaced by the body.
//!
//! Must not know: how any of it becomes C.

// They are what they would be written with.
#![allow(clippy::manual_swap)]

use crate::function;

/// Exchanges the values of two places.
#[function(rewrite)]
pub fn swap<T: Copy>(one: &mut T, other: &mut T) {
    let kept = *one;
    *one = *other;
    *other = kept;
}

/// Replaces the value of a place, and returns the old one.
#[function(rewrite)]
pub fn replace<T: Copy>(place: &mut T, value: T) -> T {
    let kept = *place;
    *place = value;
    kept
}

/// Does nothing: the name ends the value's life.
#[function(rewrite)]
pub fn drop<T>(value: T) {
    let _ = value;
}
