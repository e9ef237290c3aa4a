//! Q15 fixed-point numbers with saturating operators and a FIR filter.

use core::fmt;
use core::ops::{Add, AddAssign, Mul, Sub};

/// Signed fraction in -1..1 with fifteen fractional bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Q15(i16);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutOfRange;

impl Q15 {
    pub const MIN: Self = Self(i16::MIN);
    pub const MAX: Self = Self(i16::MAX);
    pub const ZERO: Self = Self(0);
    pub const HALF: Self = Self(1 << 14);

    pub const fn from_bits(bits: i16) -> Self {
        Self(bits)
    }

    pub const fn to_bits(self) -> i16 {
        self.0
    }

    /// numerator / denominator, for coefficient tables in constants.
    pub const fn ratio(numerator: i32, denominator: i32) -> Self {
        Self(((numerator << 15) / denominator) as i16)
    }

    fn saturate(wide: i32) -> Self {
        Self(wide.clamp(i16::MIN.into(), i16::MAX.into()) as i16)
    }
}

impl fmt::Debug for Q15 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.5}q15", f32::from(*self))
    }
}

impl From<Q15> for f32 {
    fn from(q: Q15) -> f32 {
        f32::from(q.0) / 32768.0
    }
}

impl TryFrom<f32> for Q15 {
    type Error = OutOfRange;

    fn try_from(x: f32) -> Result<Self, OutOfRange> {
        if (-1.0..1.0).contains(&x) {
            let scaled = x * 32768.0;
            Ok(Self::saturate((scaled + 0.5f32.copysign(scaled)) as i32))
        } else {
            Err(OutOfRange)
        }
    }
}

impl Add for Q15 {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self(self.0.saturating_add(rhs.0))
    }
}

impl AddAssign for Q15 {
    fn add_assign(&mut self, rhs: Self) {
        *self = *self + rhs;
    }
}

impl Sub for Q15 {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self(self.0.saturating_sub(rhs.0))
    }
}

/// Rounds to nearest; only -1 · -1 saturates.
impl Mul for Q15 {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        let product = i32::from(self.0) * i32::from(rhs.0);
        Self::saturate((product + (1 << 14)) >> 15)
    }
}

/// Accumulator with thirty fractional bits and plenty of guard bits.
#[derive(Debug, Clone, Copy, Default)]
struct Accumulator(i64);

impl Accumulator {
    fn mac(self, (a, b): (Q15, Q15)) -> Self {
        Self(self.0 + i64::from(a.0) * i64::from(b.0))
    }

    fn round(self) -> Q15 {
        let shifted = (self.0 + (1 << 14)) >> 15;
        Q15(shifted.clamp(i16::MIN.into(), i16::MAX.into()) as i16)
    }
}

pub fn dot(a: impl IntoIterator<Item = Q15>, b: impl IntoIterator<Item = Q15>) -> Q15 {
    a.into_iter().zip(b).fold(Accumulator::default(), Accumulator::mac).round()
}

#[derive(Debug, Clone)]
pub struct Fir<'c, const N: usize> {
    taps: &'c [Q15; N],
    delay: [Q15; N],
    newest: usize,
}

impl<'c, const N: usize> Fir<'c, N> {
    pub const fn new(taps: &'c [Q15; N]) -> Self {
        Self { taps, delay: [Q15::ZERO; N], newest: 0 }
    }

    pub fn push(&mut self, sample: Q15) -> Q15 {
        self.newest = self.newest.checked_sub(1).unwrap_or(N - 1);
        self.delay[self.newest] = sample;

        let (older, newer) = self.delay.split_at(self.newest);
        dot(self.taps.iter().copied(), newer.iter().chain(older).copied())
    }

    pub fn filter<'s>(
        &'s mut self,
        input: impl Iterator<Item = Q15> + 's,
    ) -> impl Iterator<Item = Q15> + 's {
        input.map(|sample| self.push(sample))
    }

    /// Filters a block and keeps every `factor`-th output.
    pub fn decimate(&mut self, input: &[Q15], factor: usize, output: &mut [Q15]) -> usize {
        let kept = self.filter(input.iter().copied()).step_by(factor);
        output.iter_mut().zip(kept).map(|(slot, y)| *slot = y).count()
    }
}
