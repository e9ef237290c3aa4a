//! Q15 fixed-point type with saturating operators and the two kernels that need
//! it: dot product and a one-pole low-pass.

use core::fmt;
use core::iter::Sum;
use core::ops::{Add, AddAssign, Mul, MulAssign, Neg, Shl, Shr, Sub, SubAssign};

/// A number in [-1, 1) with 15 fractional bits; everything saturates.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Q15(i16);

impl Q15 {
    pub const FRACTION_BITS: u32 = 15;
    pub const MAX: Self = Self(i16::MAX);
    pub const MIN: Self = Self(i16::MIN);
    pub const ZERO: Self = Self(0);
    pub const HALF: Self = Self(1 << 14);
    /// Smallest positive value.
    pub const EPSILON: Self = Self(1);

    pub const fn from_bits(bits: i16) -> Self {
        Self(bits)
    }

    pub const fn to_bits(self) -> i16 {
        self.0
    }

    pub fn from_f32(v: f32) -> Self {
        Self((v * 32768.0).round() as i16)
    }

    pub const fn abs(self) -> Self {
        Self(self.0.saturating_abs())
    }

    /// Narrows a Q30 accumulator with rounding and saturation.
    fn from_q30(acc: i64) -> Self {
        let rounded = (acc + (1 << (Self::FRACTION_BITS - 1))) >> Self::FRACTION_BITS;
        Self(rounded.clamp(i16::MIN.into(), i16::MAX.into()) as i16)
    }

    /// Quotient; `None` unless its magnitude stays below one.
    pub fn checked_div(self, rhs: Self) -> Option<Self> {
        let quotient = (i32::from(self.0) << Self::FRACTION_BITS).checked_div(rhs.0.into())?;
        i16::try_from(quotient).ok().map(Self)
    }

    /// Square root of a non-negative number, bit by bit.
    pub fn sqrt(self) -> Option<Self> {
        let n = u32::try_from(self.0).ok()? << Self::FRACTION_BITS;
        let root = (0..16).rev().map(|bit| 1_u32 << bit).fold(0, |root, bit| {
            let candidate = root | bit;
            if candidate * candidate <= n { candidate } else { root }
        });
        Some(Self(root as i16))
    }
}

impl Add for Q15 {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self(self.0.saturating_add(rhs.0))
    }
}

impl Sub for Q15 {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self(self.0.saturating_sub(rhs.0))
    }
}

impl Mul for Q15 {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        Self::from_q30(i64::from(self.0) * i64::from(rhs.0))
    }
}

impl Neg for Q15 {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.saturating_neg())
    }
}

impl Shr<u32> for Q15 {
    type Output = Self;
    fn shr(self, n: u32) -> Self {
        Self(self.0 >> n.min(15))
    }
}

impl Shl<u32> for Q15 {
    type Output = Self;
    fn shl(self, n: u32) -> Self {
        let wide = i32::from(self.0) << n.min(16);
        Self(wide.clamp(i16::MIN.into(), i16::MAX.into()) as i16)
    }
}

macro_rules! assign_ops {
    ($($trait:ident :: $method:ident => $op:tt),* $(,)?) => {$(
        impl $trait for Q15 {
            fn $method(&mut self, rhs: Self) {
                *self = *self $op rhs;
            }
        }
    )*};
}

assign_ops! {
    AddAssign::add_assign => +,
    SubAssign::sub_assign => -,
    MulAssign::mul_assign => *,
}

impl Sum for Q15 {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        let wide: i32 = iter.map(|q| i32::from(q.0)).sum();
        Self(wide.clamp(i16::MIN.into(), i16::MAX.into()) as i16)
    }
}

impl From<Q15> for f32 {
    fn from(q: Q15) -> f32 {
        f32::from(q.0) / 32768.0
    }
}

impl fmt::Debug for Q15 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.5}q15", f32::from(*self))
    }
}

/// Dot product with a wide accumulator, rounded once.
pub fn dot(a: &[Q15], b: &[Q15]) -> Q15 {
    let acc = a.iter().zip(b).map(|(x, y)| i64::from(x.0) * i64::from(y.0)).sum();
    Q15::from_q30(acc)
}

/// One-pole low-pass `y += alpha (x - y)` that keeps its state in Q30.
#[derive(Clone, Debug)]
pub struct LowPass {
    alpha: Q15,
    state: i64,
}

impl LowPass {
    pub fn new(alpha: Q15) -> Self {
        Self { alpha: alpha.clamp(Q15::EPSILON, Q15::MAX), state: 0 }
    }

    pub fn step(&mut self, x: Q15) -> Q15 {
        let error = (i64::from(x.0) << Q15::FRACTION_BITS) - self.state;
        self.state += error * i64::from(self.alpha.0) >> Q15::FRACTION_BITS;
        Q15::from_q30(self.state)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn q(v: f32) -> Q15 {
        Q15::from_f32(v)
    }

    #[test]
    fn arithmetic_saturates() {
        assert_eq!(q(0.75) + q(0.5), Q15::MAX);
        assert_eq!(-Q15::MIN, Q15::MAX);
        assert_eq!(Q15::MIN * Q15::MIN, Q15::MAX);
        assert_eq!(q(0.5) * q(-0.5), q(-0.25));
        assert_eq!(q(0.3) << 2, Q15::MAX);
        assert_eq!([q(0.9), q(0.9), q(-0.9)].into_iter().sum::<Q15>(), q(0.9));
        let mut v = q(0.5);
        v *= q(0.5);
        v -= Q15::HALF;
        assert_eq!(f32::from(v), -0.25);
    }

    #[test]
    fn division_and_root() {
        assert_eq!(q(0.25).checked_div(q(0.5)), Some(Q15::HALF));
        assert_eq!(q(0.5).checked_div(q(0.25)), None);
        assert_eq!(q(0.5).checked_div(Q15::ZERO), None);
        assert_eq!(q(0.25).sqrt(), Some(Q15::HALF));
        assert_eq!(q(-0.25).sqrt(), None);
        assert!((f32::from(Q15::MAX.sqrt().unwrap()) - 1.0).abs() < 1e-4);
    }

    #[test]
    fn kernels() {
        let a = [0.5, -0.5, 0.25].map(q);
        assert_eq!(dot(&a, &a), q(0.5625));
        let mut lp = LowPass::new(q(0.01));
        let end = (0..2000).map(|_| lp.step(q(0.6))).last().unwrap();
        assert!((f32::from(end) - 0.6).abs() < 1e-4, "{end:?}");
    }
}
