//! Operators and conversions of an author's types: implementations of Rust's traits with the attribute. In the C each
//! is a function.

use bessemer::prelude::*;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub};

/// A complex number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Phasor {
    /// The real part.
    pub re: f64,
    /// The imaginary part.
    pub im: f64,
}

#[data]
impl Add for Phasor {
    type Output = Phasor;

    /// The sum.
    fn add(self, other: Phasor) -> Phasor {
        Phasor { re: self.re + other.re, im: self.im + other.im }
    }
}

#[data]
impl Sub for Phasor {
    type Output = Self;

    /// The difference.
    fn sub(self, other: Self) -> Self::Output {
        self + -other
    }
}

#[data]
impl Mul for Phasor {
    type Output = Phasor;

    /// The product.
    fn mul(self, other: Phasor) -> Phasor {
        Phasor {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

#[data]
impl Mul<f64> for Phasor {
    type Output = Phasor;

    /// The number multiplied by a factor.
    fn mul(self, factor: f64) -> Phasor {
        Phasor { re: self.re * factor, im: self.im * factor }
    }
}

#[data]
impl Mul<i32> for Phasor {
    type Output = Phasor;

    /// The number multiplied by a count. A literal operand selects one of the two by its type.
    fn mul(self, count: i32) -> Phasor {
        self * f64::from(count)
    }
}

#[data]
impl Div<f64> for Phasor {
    type Output = Phasor;

    /// The number divided by a divisor.
    fn div(self, divisor: f64) -> Phasor {
        Phasor { re: self.re / divisor, im: self.im / divisor }
    }
}

#[data]
impl Neg for Phasor {
    type Output = Phasor;

    /// The negative number.
    fn neg(self) -> Phasor {
        Phasor { re: -self.re, im: -self.im }
    }
}

#[data]
impl AddAssign for Phasor {
    /// Adds another number in place.
    fn add_assign(&mut self, other: Phasor) {
        self.re += other.re;
        self.im += other.im;
    }
}

#[data]
impl MulAssign<f64> for Phasor {
    /// Multiplies by a factor in place.
    fn mul_assign(&mut self, factor: f64) {
        *self = *self * factor;
    }
}

#[data]
impl From<f64> for Phasor {
    /// Converts a real number.
    fn from(re: f64) -> Phasor {
        Phasor { re, im: 0.0 }
    }
}

#[data]
impl From<(f64, f64)> for Phasor {
    /// Converts a pair of real and imaginary part.
    fn from(parts: (f64, f64)) -> Self {
        let (re, im) = parts;
        Self { re, im }
    }
}

/// The error for a letter that is not a phase.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unknown(pub u8);

/// A phase of the mains.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Phase {
    /// First phase.
    #[default]
    A,
    /// Second phase.
    B,
    /// Third phase.
    C,
}

#[data]
impl TryFrom<u8> for Phase {
    type Error = Unknown;

    /// Converts a letter to a phase.
    fn try_from(letter: u8) -> Result<Self, Self::Error> {
        match letter {
            b'A' => Ok(Phase::A),
            b'B' => Ok(Phase::B),
            b'C' => Ok(Phase::C),
            other => Err(Unknown(other)),
        }
    }
}

/// The impedance of two in parallel.
#[function]
pub fn parallel(a: Phasor, b: Phasor) -> Phasor {
    let product = a * b;
    let sum = a + b;
    let length = sum.re * sum.re + sum.im * sum.im;
    let conjugate = Phasor { re: sum.re, im: -sum.im };
    product * conjugate / length
}

/// The sum of three currents, weighted.
#[function]
pub fn weighted(currents: [Phasor; 3], factor: f64) -> Phasor {
    let mut sum = Phasor::default();
    for current in currents {
        sum += current * factor;
    }
    sum *= 0.5;
    sum - currents[0]
}

/// Converts with `from` and with `into`.
#[function]
pub fn made(re: f64, im: f64) -> Phasor {
    let real: Phasor = re.into();
    real + Phasor::from((0.0, im)) * 2.0_f64 * 3_i32
}

/// The phase of a letter; an unknown letter is the error.
#[function]
pub fn phase_of(letter: u8) -> Result<Phase, Unknown> {
    let phase = Phase::try_from(letter)?;
    Ok(phase)
}

/// Converts numbers with `into`.
#[function]
pub fn widened(x: i32, y: u8) -> f64 {
    let x: f64 = x.into();
    let y: u32 = y.into();
    x + f64::from(y)
}
