//! `core::mem::swap` and `replace`, in the DSL's own Rust: a call stands for the body.
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

/// The value of a place, which takes another.
#[function(rewrite)]
pub fn replace<T: Copy>(place: &mut T, value: T) -> T {
    let kept = *place;
    *place = value;
    kept
}

/// Nothing: what is left alone ends with its name.
#[function(rewrite)]
pub fn drop<T>(value: T) {
    let _ = value;
}
