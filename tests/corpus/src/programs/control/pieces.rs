//! Chunks whose size is known only at run time.

use bessemer::prelude::*;

/// Butterflies of a fast transform, with doubling width, in place.
#[function]
pub fn butterflies(data: &mut [f32; 8]) {
    let mut half = 1;
    #[bound(3)]
    while half < 8 {
        for block in data.chunks_exact_mut(2 * half) {
            let (low, high) = block.split_at_mut(half);
            for (a, b) in low.iter_mut().zip(high) {
                let difference = *a - *b;
                *a += *b;
                *b = difference;
            }
        }
        half *= 2;
    }
}

/// Elements that are written in chunks and read afterwards.
#[function]
pub fn read_again(data: &mut [f32; 6], at: usize) -> f32 {
    let (low, high) = data.split_at_mut(at);
    let mut sum = 0.0;
    for (a, b) in low.iter_mut().zip(high) {
        *b *= 0.5;
        *a += *b;
        let kept = *b;
        sum += kept;
    }
    sum
}

/// The sums of chunks; the last chunk may be shorter.
#[function]
pub fn sums(values: &[i32], size: usize) -> [i32; 4] {
    let mut sums = [0_i32; 4];
    for (sum, piece) in sums.iter_mut().zip(values.chunks(size)) {
        for value in piece {
            *sum = sum.wrapping_add(*value);
        }
    }
    sums
}

/// The greatest mean of `size` neighbours, and the sum of every `size`-th element.
#[function]
pub fn windows(values: &[f64; 6], size: usize) -> (f64, f64) {
    let mut most = 0.0_f64;
    for window in values.windows(size) {
        let mut sum = 0.0;
        for value in window {
            sum += value;
        }
        most = most.max(sum / size as f64);
    }
    let mut some = 0.0;
    for value in values.iter().step_by(size) {
        some += value;
    }
    (most, some)
}

/// Writes to the first element of each chunk its number.
#[function]
pub fn numbered(data: &mut [u8; 7], size: usize) {
    for (number, piece) in data.chunks_mut(size).enumerate() {
        piece[0] = number as u8;
    }
}
