//! Named iterators and ranges evaluate their bounds when they are created. A fault occurs there, as in Rust, and
//! later changes of the variables have no effect.

use bessemer::prelude::*;

/// A range faults where it is created, even if no loop uses it.
#[function]
pub fn made_before(samples: &[f64; 4], n: usize, is_asked: bool) -> f64 {
    let below = 0..n - 1;
    let stepped = samples.iter().step_by(n);
    let pieces = samples.chunks(n);
    let mut sum = 0.0;
    if is_asked {
        for i in below {
            sum += i as f64;
            if sum > 100.0 {
                break;
            }
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

/// The variable has another value when the iterator is consumed.
#[function]
pub fn changed_since(samples: &[i32; 6], first: usize) -> i32 {
    let mut left = first & 3;
    let rest = samples.iter().skip(left).take(left + 2);
    left += 3;
    let numbers = left..9;
    left = 0;
    let mut sum = left as i32;
    for sample in rest {
        sum = sum.wrapping_add(*sample);
    }
    for number in numbers {
        sum = sum.wrapping_mul(number as i32);
    }
    sum
}
