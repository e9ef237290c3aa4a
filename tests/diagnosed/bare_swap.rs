//! A case.
#![no_std]
use bessemer::prelude::*;
use core::mem::swap;

/// By its last name alone `swap` may be anybody's.
#[function]
pub fn ordered(low: &mut f64, high: &mut f64) {
    if *low > *high {
        swap(low, high);
    }
}
