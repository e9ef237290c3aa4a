//! Covariances of `bessemer-estimation`: predicted and corrected, symmetric to the last bit, with a report in place of a
//! covariance that is not positive.

use bessemer::prelude::*;
use bessemer_estimation::{
    Correction, Diagonal, Factored, Selection, Status, Symmetric, discretized,
};

/// Height, m, and climb, m/s, of an aircraft.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Climb {
    /// Height and climb.
    pub state: Vector2<f64>,
    /// Covariance of their errors.
    pub covariance: Symmetric<f64, 2>,
}

impl Default for Climb {
    fn default() -> Self {
        let covariance = Symmetric::diagonal(&Vector2::new(4.0, 1.0));
        Climb { state: Vector2::zeros(), covariance }
    }
}

#[component]
impl Climb {
    /// Predicts one period, s, with an acceleration, m/s².
    #[entry(infallible)]
    pub fn predict(&mut self, acceleration: f64, period: f64) {
        let jacobian = Matrix2::new(1.0, period, 0.0, 1.0);
        self.state = jacobian * self.state + Vector2::new(0.5 * period, 1.0) * (acceleration * period);
        self.covariance.congruence(&jacobian);
        self.covariance.add_diagonal(&Vector2::new(0.0, 0.04 * period));
    }

    /// Corrects by a measured height, m; returns the report.
    #[entry(infallible)]
    pub fn measure(&mut self, height: f64, variance: f64) -> Correction<f64> {
        let innovation = height - self.state[0];
        self.covariance.correct(&mut self.state, &Vector2::new(1.0, 0.0), innovation, variance, 9.0)
    }

    /// Corrects by height and climb at once.
    #[entry]
    pub fn measure_both(&mut self, measured: &Vector2<f64>, noise: &Vector2<f64>) -> Status {
        let selection = Selection { indices: [0, 1] };
        let innovation = measured - selection.of(&self.state);
        let noise = Symmetric::diagonal(noise);
        let jacobian = Matrix2::identity();
        self.covariance
            .correct_jointly(&mut self.state, &jacobian, &innovation, &noise, 13.8)
            .status
    }
}

/// Corrects a covariance as U D Uᵀ; negative if it is not positive definite.
#[function]
pub fn by_factors(p: &Matrix3<f64>, row: &Vector3<f64>, innovation: f64) -> (f64, Vector3<f64>, Matrix3<f64>) {
    let mut state = Vector3::zeros();
    match Factored::of(&Symmetric::of_lower(p)) {
        Some(factors) => {
            let mut factors = factors;
            let report = factors.correct(&mut state, row, innovation, 0.5, 16.0);
            (report.surprise, state, *factors.covariance().matrix())
        }
        None => (-1.0, state, *p),
    }
}

/// Corrects by a certain measurement in Joseph's form, then by one that leaves the last number as it is.
#[function]
pub fn by_certain(p: &Matrix3<f64>, row: &Vector3<f64>, innovation: f64) -> (Status, Vector3<f64>, Matrix3<f64>) {
    let (mut state, mut covariance) = (Vector3::zeros(), Symmetric::of_lower(p));
    covariance.correct_joseph(&mut state, row, innovation, 1e-12, 1e9);
    let considered = [false, false, true];
    let report = covariance.correct_considering(&mut state, &considered, 1, innovation, 0.5, 16.0);
    (report.status, state, *covariance.matrix())
}

/// Corrects the last two of four numbers, which are measured with independent errors.
#[function]
pub fn by_part(p: &Matrix4<f64>, innovation: &Vector2<f64>) -> (Status, Vector4<f64>, Matrix4<f64>) {
    let (mut state, mut covariance) = (Vector4::zeros(), Symmetric::of_lower(p));
    let variances = Vector2::new(0.5, 0.25);
    let report = covariance.correct_part::<2, 2>(&mut state, innovation, &variances, 16.0);
    (report.status, state, *covariance.matrix())
}

/// Scales a covariance in single precision, and selects a part of it.
#[function]
pub fn scaled(p: &Matrix3<f32>, by: &Vector3<f32>) -> Matrix2<f32> {
    let scaled = Diagonal { values: *by }.congruence(&Symmetric::of_lower(p));
    *Selection::<2, 3> { indices: [2, 0] }.within(&scaled).matrix()
}

/// The transition of an oscillator over a period, s, and the noise that its acceleration adds.
#[function]
pub fn oscillator(frequency: f64, period: f64) -> (Matrix2<f64>, Matrix2<f64>) {
    let system = Matrix2::new(0.0, 1.0, -frequency * frequency, 0.0);
    let noise = Symmetric::diagonal(&Vector2::new(0.0, 1.0));
    let (transition, added) = discretized(&system, &noise, period, 4);
    (transition, *added.matrix())
}
