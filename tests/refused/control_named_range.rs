#![no_std]
extern crate std;

use bessemer::prelude::*;

/// What stops where it is made does so, though nobody may go through it.
#[function]
pub fn made_before(samples: &[f64; 4], n: usize, is_asked: bool) -> f64 {
    let below = 0..n - 1;
    let stepped = samples.iter().step_by(n);
    let pieces = samples.chunks(0);
    let mut sum = 0.0;
    if is_asked {
        for i in below {
            sum += i as f64;
        }
        for sample in stepped {
            sum += sample;
        }
        for piece in pieces {
            sum += piece[0];
        }
    }
    sum
}

fn main() {}
