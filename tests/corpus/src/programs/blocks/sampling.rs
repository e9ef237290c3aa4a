//! Filters over the last samples of a converter.

use bessemer::prelude::*;
pub use bessemer_blocks::{Decimator, Derivative, Fir, Integrator, IntegratorParameters, Moving, Spread};

/// A low-pass with a linear phase.
const TAPS: [f32; 5] = [0.1, 0.2, 0.4, 0.2, 0.1];

/// Smooths samples, and reports one in four.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Converter {
    fir: Fir<f32, 5>,
    decimator: Decimator<f32, 5>,
    noise: Moving<f32, 8>,
}

#[component]
impl Converter {
    /// Takes one sample; returns a value for one in four.
    #[entry(infallible)]
    pub fn step(&mut self, sample: f32) -> Option<f32> {
        let smooth = self.fir.step(&TAPS, sample);
        self.decimator.step(&TAPS, 4, smooth)
    }

    /// Takes one sample; returns mean and variance of the last eight.
    #[entry(infallible)]
    pub fn noise(&mut self, sample: f32) -> Spread<f32> {
        self.noise.spread(sample)
    }
}

/// Energy and power of a load.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Meter {
    energy: Integrator<f64>,
    slope: Derivative<f64>,
    mean: Moving<f64, 3>,
}

#[component]
impl Meter {
    /// Takes one sample of the power, W; returns the energy, J, the slope of the power, W/s, and its mean, W.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &IntegratorParameters<f64>,
        #[unit("W")] power: f64,
        reset: bool,
    ) -> [f64; 3] {
        if reset {
            self.energy.reset(0.0);
        }
        [
            self.energy.step(parameters, power),
            self.slope.step(0.05, parameters.period, power),
            self.mean.average(power),
        ]
    }
}
