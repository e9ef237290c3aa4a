//! Sine and cosine in fixed point by CORDIC (Volder 1959); numbers have 16 fractional bits.

use bessemer::prelude::*;

/// atan(2^-i) in rad, with 16 fractional bits.
const ANGLES: [i32; 14] =
    [51472, 30386, 16055, 8150, 4091, 2047, 1024, 512, 256, 128, 64, 32, 16, 8];
/// The product of the cosines of all angles, with 16 fractional bits.
const GAIN: i32 = 39797;

/// Cosine and sine of an angle from −π/2 to π/2 rad.
#[function]
pub fn cordic(angle: i32) -> [i32; 2] {
    let mut rest = angle.clamp(-102944, 102944);
    let (mut x, mut y) = (GAIN, 0_i32);
    for i in 0..14 {
        let (dx, dy) = (x >> i, y >> i);
        if rest >= 0 {
            x = x.wrapping_sub(dy);
            y = y.wrapping_add(dx);
            rest -= ANGLES[i];
        } else {
            x = x.wrapping_add(dy);
            y = y.wrapping_sub(dx);
            rest += ANGLES[i];
        }
    }
    [x, y]
}
