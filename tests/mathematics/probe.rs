//! A model that calls every elementary function on many points and folds the bits of the results.

use bessemer::math::narrow;
use bessemer::prelude::*;

/// Points of one call of [`Probe::step`].
pub const POINTS: u32 = 1_000;

/// Calls the functions on points of its own making.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Probe {
    /// Number of words drawn.
    pub drawn: u64,
}

#[component]
impl Probe {
    /// The next word of Steele, Lea and Flood's SplitMix.
    pub fn word(&mut self) -> u64 {
        self.drawn = self.drawn.wrapping_add(1);
        let start = self.drawn.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let middle = (start ^ (start >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let end = (middle ^ (middle >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        end ^ (end >> 31)
    }

    /// Draws a number. It has any bits in either format, or is near a multiple of π/2 or a row of a table, or lies in
    /// −`range` to `range`.
    pub fn argument(&mut self, range: f64) -> f64 {
        const QUARTER_TURN: f64 = core::f64::consts::FRAC_PI_2;
        let word = self.word();
        match word & 7 {
            0 => f64::from_bits(self.word()),
            1 => f32::from_bits((word >> 32) as u32) as f64,
            2 => {
                let turns = word >> (12 + (word >> 3) % 52);
                let nearest = turns as f64 * QUARTER_TURN;
                f64::from_bits(nearest.to_bits().wrapping_add(word >> 6 & 3))
            }
            3 => ((word >> 48) as f64 - 32768.0) * 0.0078125 + (word >> 16 & 7) as f64 * 1e-16,
            _ => ((word >> 11) as f64 * 2.220446049250313e-16 - 1.0) * range,
        }
    }

    /// The folded bits of function `which` on the next points.
    #[entry(infallible)]
    pub fn step(&mut self, which: u32, range: f64) -> u64 {
        let mut folded = 0u64;
        for _ in 0..POINTS {
            let x = self.argument(range);
            let y = self.argument(range);
            let value = double(which, x, y);
            folded = (folded ^ value.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            folded ^= folded >> 29;
            let value = single(which, x as f32, y as f32);
            folded = (folded ^ value.to_bits() as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            folded ^= folded >> 29;
            let value = alone(which, x as f32, y as f32);
            folded = (folded ^ value.to_bits() as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            folded ^= folded >> 29;
        }
        folded
    }
}

/// Function `which` in double precision.
#[function]
pub fn double(which: u32, x: f64, y: f64) -> f64 {
    match which {
        0 => x.sin(),
        1 => x.cos(),
        2 => x.tan(),
        3 => x.asin(),
        4 => x.acos(),
        5 => x.atan(),
        6 => x.exp(),
        7 => x.exp2(),
        8 => x.exp_m1(),
        9 => x.ln(),
        10 => x.log2(),
        11 => x.log10(),
        12 => x.ln_1p(),
        13 => x.sinh(),
        14 => x.cosh(),
        15 => x.tanh(),
        16 => x.cbrt(),
        17 => x.atan2(y),
        18 => x.powf(y),
        19 => x.hypot(y),
        20 => x.powi(y.to_bits() as i32 >> 20),
        // Where the product and what is added nearly cancel, too.
        21 => x.mul_add(y, if y > 0.0 { -x * y } else { x }),
        22 => {
            let (sine, cosine) = x.sin_cos();
            sine + 2.0 * cosine
        }
        _ => x,
    }
}

/// Function `which` in single precision.
#[function]
pub fn single(which: u32, x: f32, y: f32) -> f32 {
    match which {
        0 => x.sin(),
        1 => x.cos(),
        2 => x.tan(),
        3 => x.asin(),
        4 => x.acos(),
        5 => x.atan(),
        6 => x.exp(),
        7 => x.exp2(),
        8 => x.exp_m1(),
        9 => x.ln(),
        10 => x.log2(),
        11 => x.log10(),
        12 => x.ln_1p(),
        13 => x.sinh(),
        14 => x.cosh(),
        15 => x.tanh(),
        16 => x.cbrt(),
        17 => x.atan2(y),
        18 => x.powf(y),
        19 => x.hypot(y),
        20 => x.powi(y.to_bits() as i32 >> 20),
        // Where the product and what is added nearly cancel, too.
        21 => x.mul_add(y, if y > 0.0 { -x * y } else { x }),
        22 => {
            let (sine, cosine) = x.sin_cos();
            sine + 2.0 * cosine
        }
        _ => x,
    }
}

/// Computes the function in `f32` only, as with the feature `single` of the DSL.
#[function]
pub fn alone(which: u32, x: f32, y: f32) -> f32 {
    match which {
        0 => narrow::sinf(x),
        1 => narrow::cosf(x),
        2 => narrow::tanf(x),
        3 => narrow::asinf(x),
        4 => narrow::acosf(x),
        5 => narrow::atanf(x),
        6 => narrow::expf(x),
        7 => narrow::exp2f(x),
        8 => narrow::exp_m1f(x),
        9 => narrow::lnf(x),
        10 => narrow::log2f(x),
        11 => narrow::log10f(x),
        12 => narrow::ln_1pf(x),
        13 => narrow::sinhf(x),
        14 => narrow::coshf(x),
        15 => narrow::tanhf(x),
        16 => narrow::cbrtf(x),
        17 => narrow::atan2f(x, y),
        18 => narrow::powff(x, y),
        19 => narrow::hypotf(x, y),
        20 => narrow::powif(x, y.to_bits() as i32 >> 20),
        22 => {
            let (sine, cosine) = narrow::sin_cosf(x);
            sine + 2.0 * cosine
        }
        _ => x,
    }
}
