//! Calls of `lowpass-filter` over plain numbers.

use crate::*;

pub fn of_f32(mut signal: [f32; 12], rate: f32, cutoff: f32) -> [f32; 12] {
    lowpass_filter(&mut signal, rate, cutoff);
    signal
}

pub fn of_f64(mut signal: [f64; 12], rate: f64, cutoff: f64) -> [f64; 12] {
    lowpass_filter_f64(&mut signal, rate, cutoff);
    signal
}
