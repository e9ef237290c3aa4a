//! A function of an alias of small letters.
#![no_std]
#![allow(non_camel_case_types)]
use bessemer::prelude::*;

/// A number.
pub type f64_ = f32;

/// Its root.
#[function]
pub fn root(y: f32) -> f32 {
    f64_::sqrt(y)
}
