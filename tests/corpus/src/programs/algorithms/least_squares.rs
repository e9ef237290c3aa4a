//! Recursive least squares with forgetting for three parameters (Ljung, System Identification, 11.2).

use bessemer::prelude::*;

/// Estimated parameters and their covariance.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Identifier {
    parameters: Vector3<f64>,
    covariance: Matrix3<f64>,
}

impl Default for Identifier {
    fn default() -> Self {
        Identifier { parameters: Vector3::zeros(), covariance: Matrix3::identity() * 1000.0 }
    }
}

#[component]
impl Identifier {
    /// Updates the estimate with a measurement of `regressor · parameters`.
    #[entry(infallible)]
    pub fn step(&mut self, regressor: &Vector3<f64>, measured: f64) -> Vector3<f64> {
        const FORGETTING: f64 = 0.98;
        let spread = self.covariance * regressor;
        let gain = spread / (FORGETTING + regressor.dot(&spread));
        let surprise = measured - regressor.dot(&self.parameters);
        self.parameters += gain * surprise;
        self.covariance = (self.covariance - gain * spread.transpose()) / FORGETTING;
        self.parameters
    }
}
