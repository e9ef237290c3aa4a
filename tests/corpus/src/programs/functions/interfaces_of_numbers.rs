//! Numbers have an interface of the author's too, and operators with a type of the author's on the right.

use bessemer::prelude::*;
use core::ops::{Div, Mul};

/// Values of a stick.
#[interface]
pub trait Shaped {
    /// Nothing near the middle.
    fn without_middle(self, width: Self) -> Self;

    /// Twice as much.
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

    /// So many times as long.
    fn mul(self, length: Metres) -> Metres {
        Metres(self * length.0)
    }
}

#[data]
impl Mul<Seconds> for f64 {
    type Output = Seconds;

    /// So many times as long.
    fn mul(self, time: Seconds) -> Seconds {
        Seconds(self * time.0)
    }
}

#[data]
impl Mul<Metres> for i32 {
    type Output = Metres;

    /// So many of it.
    fn mul(self, length: Metres) -> Metres {
        f64::from(self) * length
    }
}

#[data]
impl Div<Seconds> for Metres {
    type Output = f64;

    /// A speed, m/s.
    fn div(self, time: Seconds) -> f64 {
        self.0 / time.0
    }
}

#[data]
impl From<Metres> for f64 {
    /// The number.
    fn from(length: Metres) -> f64 {
        length.0
    }
}

/// A stick as it is meant, whatever its numbers.
#[function]
pub fn meant<T: Shaped>(stick: T, width: T) -> T {
    stick.doubled().without_middle(width)
}

/// Two sticks.
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

/// The number of a length, whichever way it is asked for.
#[function]
pub fn number(length: Metres) -> f64 {
    let number: f64 = length.into();
    number + f64::from(2.0 * length)
}

/// Takes steps.
#[interface]
pub trait Counts {
    /// A step.
    fn step(&mut self, by: u8) -> bool;
}

#[data]
impl Counts for u16 {
    fn step(&mut self, by: u8) -> bool {
        *self = self.wrapping_add(u16::from(by));
        *self > 1000
    }
}

/// A number that counts.
#[function]
pub fn counted(counter: &mut u16, by: u8) -> bool {
    let often = counter.step(by);
    often && counter.step(1)
}
