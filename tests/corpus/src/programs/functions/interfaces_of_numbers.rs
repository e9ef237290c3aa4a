//! Traits of an author's own implemented for numbers, and operators with an author's type on the right.

use bessemer::prelude::*;
use core::ops::{Div, Mul};

/// Operations on the value of a stick.
#[interface]
pub trait Shaped {
    /// The value with a dead band of this width around the middle.
    fn without_middle(self, width: Self) -> Self;

    /// Twice the value.
    fn doubled(self) -> Self;
}

#[data]
impl Shaped for f64 {
    fn without_middle(self, width: f64) -> f64 {
        if self.abs() < width { 0.0 } else { self }
    }

    fn doubled(self) -> f64 {
        self * 2.0
    }
}

#[data]
impl Shaped for i16 {
    fn without_middle(self, width: i16) -> i16 {
        if (-width..=width).contains(&self) { 0 } else { self }
    }

    fn doubled(self) -> i16 {
        self.saturating_mul(2)
    }
}

/// A length, m.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Metres(pub f64);

/// A time, s.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds(pub f64);

#[data]
impl Mul<Metres> for f64 {
    type Output = Metres;

    /// The length multiplied by a number.
    fn mul(self, length: Metres) -> Metres {
        Metres(self * length.0)
    }
}

#[data]
impl Mul<Seconds> for f64 {
    type Output = Seconds;

    /// The time multiplied by a number.
    fn mul(self, time: Seconds) -> Seconds {
        Seconds(self * time.0)
    }
}

#[data]
impl Mul<Metres> for i32 {
    type Output = Metres;

    /// The length multiplied by a count.
    fn mul(self, length: Metres) -> Metres {
        f64::from(self) * length
    }
}

#[data]
impl Div<Seconds> for Metres {
    type Output = f64;

    /// The speed as a length divided by a time, m/s.
    fn div(self, time: Seconds) -> f64 {
        self.0 / time.0
    }
}

#[data]
impl From<Metres> for f64 {
    /// The length as a number, m.
    fn from(length: Metres) -> f64 {
        length.0
    }
}

/// The command of a stick, whatever its number type.
#[function]
pub fn meant<T: Shaped>(stick: T, width: T) -> T {
    stick.doubled().without_middle(width)
}

/// Commands of two sticks with different number types.
#[function]
pub fn sticks(fine: f64, coarse: i16) -> f64 {
    meant(fine, 0.25) + f64::from(meant(coarse, 10)) + fine.doubled()
}

/// Speed, m/s.
#[function]
pub fn speed(step: Metres, count: i32, period: Seconds) -> f64 {
    let way = 0.5 * (count * step);
    way / (2.0 * period)
}

/// The length as a number, by `from` and by `into`.
#[function]
pub fn number(length: Metres) -> f64 {
    let number: f64 = length.into();
    number + f64::from(2.0 * length)
}

/// Types that count steps.
#[interface]
pub trait Counts {
    /// Adds a step; returns false if it does not fit.
    fn step(&mut self, by: u8) -> bool;
}

#[data]
impl Counts for u16 {
    fn step(&mut self, by: u8) -> bool {
        *self = self.wrapping_add(u16::from(by));
        *self > 1000
    }
}

/// Adds a step to a number.
#[function]
pub fn counted(counter: &mut u16, by: u8) -> bool {
    let often = counter.step(by);
    often && counter.step(1)
}
