//! A struct without fields selects an implementation or an error at
//! compile time. The C omits it; its methods keep their other parameters.

use bessemer::prelude::*;

/// Rules of numerical integration.
#[interface]
pub trait Rule {
    /// The area between two samples.
    fn area(&self, left: f64, right: f64, step: f64) -> f64;
}

/// Integrates with the mean of two samples.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trapezoid;

#[data]
impl Rule for Trapezoid {
    fn area(&self, left: f64, right: f64, step: f64) -> f64 {
        0.5 * (left + right) * step
    }
}

/// Integrates with the earlier sample.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rectangle;

#[data]
impl Rule for Rectangle {
    fn area(&self, left: f64, _right: f64, step: f64) -> f64 {
        left * step
    }
}

/// An integral, by either rule.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Integral<R> {
    rule: R,
    last: f64,
    sum: f64,
}

#[component]
impl<R: Rule> Integral<R> {
    /// Adds a sample.
    #[entry(infallible)]
    pub fn step(&mut self, sample: f64) -> f64 {
        self.sum += self.rule.area(self.last, sample, 0.01);
        self.last = sample;
        self.sum
    }
}

/// The integral that flies.
#[component]
pub type TrapezoidIntegral = Integral<Trapezoid>;

/// The error for a value above the limit.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saturated;

/// Errors of a value out of range.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Trouble {
    /// Above the upper limit.
    High,
    /// Below the lower limit.
    Low,
}

#[data]
impl From<Saturated> for Trouble {
    fn from(_: Saturated) -> Trouble {
        Trouble::High
    }
}

/// The torque, if the drive can produce it.
#[function]
pub fn commanded(torque: f64) -> Result<f64, Saturated> {
    if torque > 2.0 { Err(Saturated) } else { Ok(torque) }
}

/// The torque, if it is between both limits.
#[function]
pub fn limited(torque: f64) -> Result<f64, Trouble> {
    let torque = commanded(torque)?;
    if torque < -2.0 { Err(Trouble::Low) } else { Ok(torque) }
}

#[function]
fn areas<R: Rule>(rule: R, samples: &[f64; 4]) -> f64 {
    samples.windows(2).map(|pair| rule.area(pair[0], pair[1], 0.5)).sum()
}

/// Integrals by both rules.
#[function]
pub fn compared(samples: &[f64; 4]) -> [f64; 2] {
    [areas(Trapezoid, samples), areas(Rectangle, samples)]
}
