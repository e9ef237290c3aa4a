//! Functions and constructors instead of closures: with none, one, two and three arguments, by reference, and of
//! types.

use core::cmp::Ordering;

use bessemer::prelude::*;

/// A length.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stretch(pub f64);

#[data]
impl Stretch {
    /// The number in metres.
    pub fn length(&self) -> f64 {
        self.0
    }

    /// Returns true if the length is above a limit.
    pub fn is_long(&self) -> bool {
        self.0 > 1.0
    }
}

/// Errors with or without a number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Lapse {
    #[default]
    Unknown,
    Code(u8),
}

#[function]
fn fallback() -> f64 {
    0.5
}

#[function]
fn halved(x: f64) -> f64 {
    0.5 * x
}

#[function]
fn recovered(lapse: Lapse) -> Result<f64, Lapse> {
    match lapse {
        Lapse::Unknown => Err(lapse),
        Lapse::Code(code) => Ok(f64::from(code)),
    }
}

#[function]
fn is_above(x: &f64) -> bool {
    *x > 0.0
}

/// Functions passed to methods of options and results.
#[function]
pub fn one_by_one(x: Option<f64>, y: Result<f64, u8>) -> (f64, f64, Option<Stretch>, f64) {
    let z = y.map_err(Lapse::Code).or_else(recovered);
    (
        x.map_or_else(fallback, halved),
        x.filter(is_above).unwrap_or_else(fallback),
        x.map(f64::abs).map(f64::sqrt).map(Stretch),
        z.unwrap_or(0.25),
    )
}

/// Functions of two arguments, and on matrices.
#[function]
pub fn two_by_two(samples: &[f64; 4], m: &Matrix2<f64>) -> (f64, Option<f64>, Matrix2<f64>, Option<f64>) {
    (
        samples.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        samples.iter().copied().reduce(f64::min),
        m.zip_map(m, f64::atan2),
        samples.iter().copied().max_by(f64::total_cmp),
    )
}

/// Functions that take references, and constructors of the result.
#[function]
pub fn by_reference(lengths: [f64; 3]) -> (f64, usize, [Stretch; 3]) {
    let spans = lengths.map(Stretch);
    let sum = spans.iter().map(Stretch::length).sum();
    (sum, spans.iter().copied().filter(Stretch::is_long).count(), spans)
}

/// A type with methods that take closures and enums.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Amplifier {
    pub gain: f64,
    pub last: Lapse,
}

#[data]
impl Amplifier {
    /// Applies a function to the gain.
    pub fn applied(&self, f: impl Fn(f64) -> f64) -> f64 {
        f(self.gain)
    }

    /// Stores the number of a variant.
    pub fn set(&mut self, lapse: Lapse) {
        self.last = lapse;
    }
}

#[function]
fn twice(x: f64, f: impl Fn(f64) -> f64) -> f64 {
    f(f(x))
}

/// Functions passed to an author's own methods that take closures, and variants to those that take enums.
#[function]
pub fn own(amplifier: &mut Amplifier, code: u8) -> f64 {
    amplifier.set(Lapse::Code(code));
    let first = amplifier.applied(halved) + amplifier.applied(f64::cos);
    amplifier.set(Lapse::Unknown);
    first + twice(first, f64::sin)
}

#[function]
fn descending(one: &i16, other: &i16) -> Ordering {
    other.cmp(one)
}

#[function]
fn low_bits(number: &i16) -> i16 {
    *number & 7
}

/// Functions passed to sorts.
#[function]
pub fn sorted(mut numbers: [i16; 5], mut levels: [f32; 4]) -> ([i16; 5], [i16; 5], [f32; 4]) {
    numbers.sort_by(descending);
    let before = numbers;
    numbers.sort_by_key(low_bits);
    levels.sort_unstable_by(f32::total_cmp);
    (before, numbers, levels)
}
