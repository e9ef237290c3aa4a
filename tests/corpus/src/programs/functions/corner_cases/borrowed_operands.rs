//! Operators and conversions implemented for references, with or without those for values.

use core::ops::{Add, AddAssign, Mul, Neg, Sub};

use bessemer::prelude::*;

/// An array of words with arithmetic modulo 2³².
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Words<const N: usize> {
    of: [u32; N],
}

#[data]
impl<const N: usize> Words<N> {
    /// Applies a function to each pair of words.
    fn with(&self, other: &Words<N>, f: impl Fn(u32, u32) -> u32) -> Words<N> {
        let mut of = self.of;
        for (word, other) in of.iter_mut().zip(&other.of) {
            *word = f(*word, *other);
        }
        Words { of }
    }
}

#[data]
impl<const N: usize> Add<&Words<N>> for &Words<N> {
    type Output = Words<N>;

    fn add(self, other: &Words<N>) -> Words<N> {
        self.with(other, |a, b| a.wrapping_add(b))
    }
}

#[data]
impl<const N: usize> Add<Words<N>> for &Words<N> {
    type Output = Words<N>;

    fn add(self, other: Words<N>) -> Words<N> {
        self + &other
    }
}

#[data]
impl<const N: usize> Add<&Words<N>> for Words<N> {
    type Output = Words<N>;

    fn add(self, other: &Words<N>) -> Words<N> {
        &self + other
    }
}

#[data]
impl<const N: usize> Add for Words<N> {
    type Output = Words<N>;

    fn add(self, other: Words<N>) -> Words<N> {
        &self + &other
    }
}

#[data]
impl<const N: usize> AddAssign<&Words<N>> for Words<N> {
    fn add_assign(&mut self, other: &Words<N>) {
        for (word, other) in self.of.iter_mut().zip(&other.of) {
            *word = word.wrapping_add(*other);
        }
    }
}

#[data]
impl<'a, const N: usize> Sub<&'a Words<N>> for &'a Words<N> {
    type Output = Words<N>;

    fn sub(self, other: &'a Words<N>) -> Words<N> {
        self.with(other, u32::wrapping_sub)
    }
}

#[data]
impl<const N: usize> Mul<u32> for &Words<N> {
    type Output = Words<N>;

    fn mul(self, factor: u32) -> Words<N> {
        Words { of: self.of.map(|word| word.wrapping_mul(factor)) }
    }
}

#[data]
impl<const N: usize> Neg for &Words<N> {
    type Output = Words<N>;

    fn neg(self) -> Words<N> {
        Words { of: self.of.map(|word| !word) }
    }
}

/// Each combination of values and references.
#[function]
pub fn pairs(a: [u32; 3], b: [u32; 3]) -> [u32; 3] {
    let (a, b) = (Words { of: a }, Words { of: b });
    let mut sum = &a + &b;
    sum += &a;
    let other = a.clone() + &sum + (&b + sum.clone());
    let turned = -&(&other - &(&a * 5));
    (turned + sum).of
}

/// The parts of a frame.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    unit: u8,
    data: &'a [u8],
}

/// Reason why a frame is malformed.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Malformed {
    /// The frame is empty.
    Empty,
    /// The unit number is invalid.
    Nobody,
}

#[data]
impl<'a> TryFrom<&'a [u8]> for Frame<'a> {
    type Error = Malformed;

    fn try_from(raw: &'a [u8]) -> Result<Self, Malformed> {
        let (unit, data) = raw.split_first().ok_or(Malformed::Empty)?;
        if *unit == 0 {
            return Err(Malformed::Nobody);
        }
        Ok(Self { unit: *unit, data })
    }
}

/// Digest of words and frames.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Digest(u32);

#[data]
impl<const N: usize> From<&Words<N>> for Digest {
    fn from(words: &Words<N>) -> Digest {
        Digest(words.of.iter().fold(17, |digest, word| digest ^ word.rotate_left(3)))
    }
}

#[data]
impl From<&Frame<'_>> for Digest {
    fn from(frame: &Frame<'_>) -> Digest {
        Digest(frame.data.iter().fold(u32::from(frame.unit), |sum, byte| {
            sum.wrapping_mul(31).wrapping_add(u32::from(*byte))
        }))
    }
}

#[data]
impl From<&[u16; 2]> for Digest {
    fn from([high, low]: &[u16; 2]) -> Digest {
        Digest(u32::from(*high) << 16 | u32::from(*low))
    }
}

/// Conversions by a named function and by `into`.
#[function]
pub fn digests(words: [u32; 4], bytes: &[u8; 6], cut: usize) -> Result<[u32; 4], Malformed> {
    let words = Words { of: words };
    let first = Frame::try_from(&bytes[..])?;
    let second: Frame = bytes[cut % 7..].try_into()?;
    let pair = [words.of[0] as u16, words.of[1] as u16];
    let last: Digest = (&pair).into();
    Ok([Digest::from(&words).0, Digest::from(&first).0, Digest::from(&second).0, last.0])
}
