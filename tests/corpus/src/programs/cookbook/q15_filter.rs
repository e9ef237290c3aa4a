//! Fixed point: a low-pass for a processor without a floating-point unit.
//!
//! Numbers are Q15: an `i16` with 15 bits behind the point, from -1 to just below 1. The state keeps 15 bits more, so
//! that small inputs do not get stuck on their way.

use bessemer::prelude::*;

/// A number from -1 to 1 - 2⁻¹⁵, in steps of 2⁻¹⁵.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Q15(pub i16);

#[data]
impl core::ops::Mul for Q15 {
    type Output = Q15;

    /// The product, rounded to nearest; -1 times -1 is 1 - 2⁻¹⁵.
    fn mul(self, other: Q15) -> Q15 {
        let wide = (i32::from(self.0) * i32::from(other.0) + (1 << 14)) >> 15;
        Q15(wide.min(32767) as i16)
    }
}

/// A low-pass of first order.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Q15LowPass {
    /// The output with 30 bits behind the point.
    level: i32,
}

#[component]
impl Q15LowPass {
    /// One sample: moves the output by `share` of the way to `sample`, times `gain`. `share` is 0 or more.
    #[entry(infallible)]
    pub fn step(&mut self, gain: Q15, share: Q15, sample: Q15) -> Q15 {
        let target = i64::from((gain * sample).0) << 15;
        let way = (target - i64::from(self.level)) * i64::from(share.0.max(0));
        let level = i64::from(self.level) + (way >> 15);
        self.level = level.clamp(-(1 << 30), (1 << 30) - 1) as i32;
        Q15(((self.level + (1 << 14)) >> 15).min(32767) as i16)
    }
}
