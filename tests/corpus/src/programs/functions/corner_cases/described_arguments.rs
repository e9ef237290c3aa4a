//! Parameters whose types only a bound describes, such as `impl Into<T>`, in functions and methods of generic types.
//! An interface has a default for a parameter that need not be sized.

use bessemer::prelude::*;

/// Takes a gain of any type that becomes a `T`.
#[function]
fn scaled<T: Real>(gain: impl Into<T>, value: T) -> T {
    gain.into() * value
}

/// A builder of gains, as a library has it.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains<T> {
    p: T,
    i: T,
}

#[data]
impl<T: Real> Gains<T> {
    /// Sets one gain.
    pub fn p(mut self, gain: impl Into<T>) -> Self {
        self.p = gain.into();
        self
    }

    /// Sets the other, by a named parameter.
    pub fn i<G: Into<T>>(mut self, gain: G, scale: impl Into<T> + Copy) -> Self {
        self.i = gain.into() * scale.into();
        self
    }
}

/// Processes samples with a state; most have none.
#[interface]
pub trait Process<X, S: ?Sized = ()> {
    /// Processes a sample.
    fn process(&self, state: &mut S, sample: X) -> X;
}

#[data]
impl Process<f32> for Gains<f32> {
    fn process(&self, _state: &mut (), sample: f32) -> f32 {
        self.p * sample
    }
}

#[data]
impl Process<f64, f64> for Gains<f64> {
    fn process(&self, state: &mut f64, sample: f64) -> f64 {
        *state += self.i * sample;
        self.p * sample + *state
    }
}

#[function]
pub fn arguments(x: f32, y: f64, n: i16) -> (f32, f64) {
    let single = scaled(2_u8, x) + scaled(x, 0.5);
    (single, scaled(n, y) + scaled(x, y))
}

#[function]
pub fn processed(x: f32, y: f64) -> (f32, f64) {
    let single = Gains::<f32>::default().p(3_u8).i(2_i8, x);
    let double = Gains::<f64>::default().p(x).i(2_i32, 0.5_f32);
    let mut state = y;
    (single.process(&mut (), x) + single.i, double.process(&mut state, 2.0) + state)
}
