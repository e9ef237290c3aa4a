//! A recursive function has no C, so no derivative.
#![no_std]
use bessemer::prelude::*;

#[function]
pub fn power(x: f64, times: u32) -> f64 {
    if times == 0 { 1.0 } else { x * power(x, times - 1) }
}

#[function(derivative(power, x))]
pub fn power_slope(x: f64, times: u32) -> (f64, f64) {
    todo!()
}
