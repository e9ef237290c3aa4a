//! Where the functions are measured: easy points, every magnitude, and the hard cases.

use rug::Float;
use rug::float::Constant;

use crate::subjects::Subject;

/// A repeatable sequence of points.
pub struct Points {
    state: u64,
    half_pi: Float,
}

/// Worth a look in every function.
const SPECIAL: &[f64] = &[
    0.0,
    -0.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    1.0,
    -1.0,
    0.5,
    2.0,
    10.0,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    5e-324,
    -5e-324,
    2.225073858507201e-308,
    1e22,
    1e300,
    0.125,
    0.25,
    22.0,
    750.0,
    // The doubles nearest to multiples of π/2 (Muller, Elementary Functions, chapter 11).
    5.319372648326541e255,
    6.134899525417045e17,
    7.12e18,
    709.782712893384,
    710.4758600739439,
    -745.1332191019411,
    -708.3964185322641,
    1_600_000.0,
];

impl Points {
    pub fn new(seed: u64) -> Points {
        let half_pi = Float::with_val(1300, Constant::Pi) / 2u32;
        Points { state: seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678, half_pi }
    }

    /// Splitmix64.
    fn word(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.word() >> 11) as f64 / 9_007_199_254_740_992.0
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Any bits; half the time within the range of a float.
    fn anywhere(&mut self) -> f64 {
        if self.word() & 1 == 0 {
            f64::from_bits(self.word())
        } else {
            f64::from(f32::from_bits(self.word() as u32))
        }
    }

    fn small(&mut self) -> f64 {
        let exponent = self.between(-40.0, 4.0).floor() as i32;
        let sign = if self.word() & 1 == 0 { 1.0 } else { -1.0 };
        sign * self.between(1.0, 2.0) * 2f64.powi(exponent)
    }

    /// A double next to a multiple of π/2.
    fn near_quarter_turn(&mut self) -> f64 {
        let bits = 1 + (self.word() % 62) as u32;
        let turns = self.word() >> (64 - bits);
        let angle = Float::with_val(1300, &self.half_pi * turns).to_f64();
        let off = (self.word() % 5) as i64 - 2;
        f64::from_bits(angle.to_bits().wrapping_add_signed(off))
    }

    fn argument(&mut self, subject: &Subject, which: usize, index: u64) -> f64 {
        let (low, high) = subject.range[which];
        match index % 16 {
            0 | 1 => self.anywhere(),
            2 | 3 => self.small(),
            // Around the ends of the tables' cells, and around 1.
            4 => self.between(-130.0, 130.0).round() / 128.0 + self.small() * 1e-7,
            5 => 1.0 + self.small() * 0.01,
            6 if subject.periodic => self.near_quarter_turn(),
            6 => 1.0 - self.small().abs() * 1e-3,
            _ => self.between(low, high),
        }
    }

    /// The point of this index.
    pub fn next(&mut self, subject: &Subject, index: u64) -> (f64, f64) {
        let specials = SPECIAL.len() as u64;
        if index < specials * specials {
            return (SPECIAL[(index % specials) as usize], SPECIAL[(index / specials) as usize]);
        }
        let x = self.argument(subject, 0, index);
        let other = self.word() >> 7;
        let y = self.argument(subject, 1, other);
        // Coordinates of like size, and powers that stay in range.
        match other % 11 {
            0 | 1 if subject.name == "powf" => {
                let logarithm = x.abs().ln();
                let size = self.between(-750.0, 750.0);
                (x.abs(), if logarithm == 0.0 { y } else { size / logarithm })
            }
            0 | 1 => (x, x * self.between(0.2, 5.0)),
            2 => (x, (x * self.between(-8.0, 8.0)).round()),
            _ => (x, y),
        }
    }
}
