//! A filter of an attitude's errors: rates turn a quaternion, and the covariance has three small angles and the gyroscope's bias.

use bessemer::prelude::*;
use bessemer_estimation::{Correction, Symmetric};

/// Attitude and bias of a gyroscope.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, State)]
pub struct Pointing {
    /// From the body's frame to the world's.
    pub attitude: UnitQuaternion<f64>,
    /// Bias of the measured rates, rad/s.
    pub bias: Vector3<f64>,
}

/// A filter of the errors of attitude and bias.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct PointingFilter {
    /// Attitude and bias.
    pub state: Pointing,
    /// Covariance of their errors.
    pub covariance: Symmetric<f64, { Pointing::ERRORS }>,
}

impl Default for PointingFilter {
    fn default() -> Self {
        let variances = SVector::from([0.1, 0.1, 0.1, 1e-3, 1e-3, 1e-3]);
        PointingFilter { state: Pointing::default(), covariance: Symmetric::diagonal(&variances) }
    }
}

#[component]
impl PointingFilter {
    /// Advances by measured rates, rad/s, over a period, s.
    #[entry(infallible)]
    pub fn predict(&mut self, rates: &Vector3<f64>, period: f64) {
        let turn = (rates - self.state.bias) * period;
        let step = bessemer::rotation::from_scaled_axis(turn);
        self.state.attitude = self.state.attitude * step;

        // The errors are in the body's frame, which moves away from them.
        let back = step.inverse().to_rotation_matrix();
        let mut jacobian = SMatrix::<f64, 6, 6>::identity();
        for row in 0..3 {
            for col in 0..3 {
                jacobian[(Pointing::ATTITUDE + row, Pointing::ATTITUDE + col)] = back[(row, col)];
            }
            jacobian[(Pointing::ATTITUDE + row, Pointing::BIAS + row)] = -period;
        }
        self.covariance.congruence(&jacobian);
        let (wander, drift) = (1e-6 * period, 1e-8 * period);
        self.covariance.add_diagonal(&SVector::from([wander, wander, wander, drift, drift, drift]));
    }

    /// Corrects by a direction known in the world's frame and measured in the body's, both of length 1.
    #[entry(infallible)]
    pub fn measure(&mut self, known: &Vector3<f64>, measured: &Vector3<f64>) -> Correction<f64> {
        let expected = self.state.attitude.inverse() * known;
        // A small turn δ of the body changes what it sees of v by v × δ.
        let cross = expected.cross_matrix();
        let mut jacobian = SMatrix::<f64, 3, 6>::zeros();
        for row in 0..3 {
            for col in 0..3 {
                jacobian[(row, Pointing::ATTITUDE + col)] = cross[(row, col)];
            }
        }
        let noise = Symmetric::diagonal(&Vector3::new(1e-4, 1e-4, 1e-4));
        let mut errors = SVector::zeros();
        let report =
            self.covariance.correct_jointly(&mut errors, &jacobian, &(measured - expected), &noise, 100.0);
        self.state = self.state.retracted(&errors);
        report
    }
}
