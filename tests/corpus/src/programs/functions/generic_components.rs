//! A generic component becomes C for each instance that its author names,
//! under that name. An instance inside another component needs no name.

use bessemer::prelude::*;

/// A PI controller.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pi<T> {
    /// The integral of the error.
    integral: T,
}

#[component]
impl<T: Real> Pi<T> {
    /// Gain of the integral.
    const GAIN: f64 = 0.1;

    /// One period; returns the command.
    #[entry(infallible)]
    pub fn step(&mut self, error: T, period: T) -> T {
        self.integral = (self.integral + error * period).clamp(-T::ONE, T::ONE);
        error + self.integral * real(Self::GAIN)
    }
}

/// The controller of the fast loop, in single precision.
#[component]
pub type FastPi = Pi<f32>;

/// The last `N` values, oldest first.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Delay<T: Real, const N: usize> {
    line: [T; N],
    oldest: usize,
}

impl<T: Real, const N: usize> Default for Delay<T, N> {
    fn default() -> Self {
        Delay { line: [T::ZERO; N], oldest: 0 }
    }
}

#[component]
impl<T: Real, const N: usize> Delay<T, N> {
    /// Adds a value and returns that of `N` periods ago.
    #[entry]
    pub fn push(&mut self, value: T) -> T {
        let old = self.line[self.oldest];
        self.line[self.oldest] = value;
        self.oldest = (self.oldest + 1) % N;
        old
    }
}

/// A loop with a dead time of four periods.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Delayed {
    pi: Pi<f64>,
    dead_time: Delay<f64, 4>,
}

#[component]
impl Delayed {
    /// One period of 10 ms.
    #[entry]
    pub fn step(&mut self, error: f64) -> f64 {
        let late = self.dead_time.push(error);
        self.pi.step(late, 0.01)
    }
}
