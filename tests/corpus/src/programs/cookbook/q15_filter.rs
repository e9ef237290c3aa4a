//! Fixed point: a low-pass for a processor without a floating-point unit.
//!
//! Numbers are Q15: an `i16` with 15 fractional bits, from -1 to just below 1. The state has 15 more bits, so that
//! small inputs are not lost by rounding.

use bessemer::prelude::*;

/// A number from -1 to 1 - 2⁻¹⁵, in steps of 2⁻¹⁵.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Q15(pub i16);

#[data]
impl core::ops::Mul for Q15 {
    type Output = Q15;

    /// The product, rounded to nearest; -1 times -1 is limited to 1 - 2⁻¹⁵.
    fn mul(self, other: Q15) -> Q15 {
        let wide = (i32::from(self.0) * i32::from(other.0) + (1 << 14)) >> 15;
        Q15(wide.min(32767) as i16)
    }
}

/// A first-order low-pass.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Q15LowPass {
    /// The output, with 30 fractional bits.
    level: i32,
}

#[component]
impl Q15LowPass {
    /// Takes one sample: moves the output towards `sample` times `gain` by the fraction `share` of the distance.
    /// `share` is 0 or more.
    #[entry(infallible)]
    pub fn step(&mut self, gain: Q15, share: Q15, sample: Q15) -> Q15 {
        let target = i64::from((gain * sample).0) << 15;
        let way = (target - i64::from(self.level)) * i64::from(share.0.max(0));
        let level = i64::from(self.level) + (way >> 15);
        self.level = level.clamp(-(1 << 30), (1 << 30) - 1) as i32;
        Q15(((self.level + (1 << 14)) >> 15).min(32767) as i16)
    }
}
