//! Noise suppression: a first-order low-pass for three signals at once.

use bessemer::prelude::*;

/// The filtered signals.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LowPass {
    /// Filtered values.
    pub level: Vector3<f64>,
}

#[component]
impl LowPass {
    /// Advances one period: moves the values by `share`, 0 to 1, of the difference to the signals.
    ///
    /// For a corner at f and a period T the share is 1 − exp(−2π f T).
    #[entry(infallible)]
    pub fn step(&mut self, share: f64, signal: &Vector3<f64>) -> Vector3<f64> {
        self.level += (signal - self.level) * share;
        self.level
    }
}
