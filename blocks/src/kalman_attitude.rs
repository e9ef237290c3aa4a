//! Error-state Kalman filter of an attitude and of a gyroscope's bias.
//!
//! Frames and sensors are those of [`crate::attitude`]. The covariance is of `bessemer_estimation`, which keeps it
//! symmetric and positive.

use bessemer::prelude::*;
use bessemer_estimation::{Correction, Status, Symmetric};

use crate::attitude::up;

/// Noise of the sensors of an [`ErrorStateFilter`].
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorStateNoise<T> {
    /// Density of the rates' noise, 0 or more.
    #[unit("rad²/s")]
    pub rates: T,
    /// Density of the bias's drift, 0 or more.
    #[unit("rad²/s³")]
    pub drift: T,
    /// Variance of the force over its length, above 0: of vibration and accelerations.
    pub force: T,
    /// Surprise above which a force is rejected: about 16, since a force of three numbers has 3 on average.
    pub gate: T,
    /// Period, above 0.
    #[unit("s")]
    pub period: T,
}

/// Error-state Kalman filter: gyroscope, accelerometer, and other directions such as the magnetic field.
///
/// The state is an attitude q and a bias b, their errors a rotation vector ε in the body's frame and a difference:
/// q ⊗ exp(ε/2) and b + β are the truth. A period rotates q by (ω − b) h, with ε' = R((ω − b) h)ᵀ ε − h β. A measured
/// direction m of one that is d in the world gives ν = m − v and H = ([v]×, 0), with the estimate v = R(q)ᵀ d. The errors
/// become part of the state, and are 0 again. A force of 0 gives no correction; samples that are not finite are ignored.
/// Initialisation: [`ErrorStateFilter::begin`]; `Default` is level and without bias, with standard deviations of 0.3 rad and
/// 0.03 rad/s. Source: Solà, *Quaternion kinematics for the error-state Kalman filter*, 2017, sections 5 and 6.
///
/// ```
/// use bessemer_blocks::{ErrorStateFilter, ErrorStateNoise};
/// use bessemer::nalgebra::Vector3;
///
/// let noise = ErrorStateNoise { rates: 1e-6, drift: 1e-8, force: 1e-4, gate: 1e6, period: 0.01_f64 };
/// let mut filter = ErrorStateFilter::default();
/// let (tilted, bias) = (Vector3::new(0.0, 0.6, 0.8), Vector3::new(0.02, 0.0, 0.0));
/// for _ in 0..2000 {
///     filter.step(&noise, &bias, &tilted);
/// }
/// assert!((filter.up() - tilted).norm() < 1e-3);
/// assert!((filter.bias() - bias).norm() < 1e-3);
/// ```
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorStateFilter<T: Real> {
    /// The attitude.
    attitude: UnitQuaternion<T>,
    /// Bias of the gyroscope.
    #[unit("rad/s")]
    bias: Vector3<T>,
    /// Covariance of the errors: three of the attitude, three of the bias.
    covariance: Symmetric<T, 6>,
}

impl<T: Real> Default for ErrorStateFilter<T> {
    fn default() -> Self {
        let (angle, rate) = (real::<T>(0.09), real::<T>(0.0009));
        ErrorStateFilter {
            attitude: UnitQuaternion::identity(),
            bias: Vector3::zeros(),
            covariance: Symmetric::diagonal(&Vector6::new(angle, angle, angle, rate, rate, rate)),
        }
    }
}

#[component]
impl<T: Real> ErrorStateFilter<T> {
    /// Begins with an attitude and without bias; `variances` are those of the errors, above 0.
    #[entry(infallible)]
    pub fn begin(&mut self, attitude: &UnitQuaternion<T>, variances: &Vector6<T>) {
        self.attitude = *attitude;
        self.bias = Vector3::zeros();
        self.covariance = Symmetric::diagonal(variances);
    }

    /// Takes one sample of rates, rad/s, and force, in any unit; returns the attitude.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        noise: &ErrorStateNoise<T>,
        rates: &Vector3<T>,
        force: &Vector3<T>,
    ) -> UnitQuaternion<T> {
        self.predict(noise, rates);
        self.correct(&Vector3::z(), force, noise.force, noise.gate);
        self.attitude
    }

    /// Rotates by the rates of one period.
    #[entry(infallible)]
    pub fn predict(&mut self, noise: &ErrorStateNoise<T>, rates: &Vector3<T>) {
        let turn = (rates - self.bias) * noise.period;
        if !turn.norm_squared().is_finite() {
            return;
        }
        let turned = UnitQuaternion::from_scaled_axis(turn);
        let back = turned.inverse().to_rotation_matrix();
        let mut jacobian = Matrix6::<T>::identity();
        for row in 0..3 {
            for column in 0..3 {
                jacobian[(row, column)] = back[(row, column)];
            }
            jacobian[(row, row + 3)] = -noise.period;
        }
        self.attitude = UnitQuaternion::from_quaternion((self.attitude * turned).into_inner());
        self.covariance.congruence(&jacobian);
        let (angle, rate) = (noise.rates * noise.period, noise.drift * noise.period);
        self.covariance.add_diagonal(&Vector6::new(angle, angle, angle, rate, rate, rate));
    }

    /// Corrects by a direction that is `direction`, of length 1, in the world's frame, and `measured`, in any unit, in
    /// the body's. `variance` belongs to the measurement over its length; a surprise above `gate` is rejected.
    #[entry(infallible)]
    pub fn correct(
        &mut self,
        direction: &Vector3<T>,
        measured: &Vector3<T>,
        variance: T,
        gate: T,
    ) -> Correction<T> {
        let length = measured.norm();
        if !(length > T::ZERO && length.is_finite()) {
            return Correction { surprise: T::ZERO, status: Status::Rejected };
        }
        let expected = self.attitude.inverse_transform_vector(direction);
        let across = expected.cross_matrix();
        let mut jacobian = SMatrix::<T, 3, 6>::zeros();
        for row in 0..3 {
            for column in 0..3 {
                jacobian[(row, column)] = across[(row, column)];
            }
        }
        let innovation = measured / length - expected;
        let noise = Symmetric::diagonal(&Vector3::repeat(variance));
        let mut errors = Vector6::<T>::zeros();
        let found =
            self.covariance.correct_jointly(&mut errors, &jacobian, &innovation, &noise, gate);
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(errors[0], errors[1], errors[2]));
        self.attitude = UnitQuaternion::from_quaternion((self.attitude * turn).into_inner());
        self.bias += Vector3::new(errors[3], errors[4], errors[5]);
        found
    }

    /// Returns the attitude.
    #[entry(infallible)]
    pub fn attitude(&self) -> UnitQuaternion<T> {
        self.attitude
    }

    /// Returns the direction of up in the body's frame.
    #[entry(infallible)]
    pub fn up(&self) -> Vector3<T> {
        up(&self.attitude)
    }

    /// Returns the bias of the gyroscope, rad/s.
    #[entry(infallible)]
    pub fn bias(&self) -> Vector3<T> {
        self.bias
    }
}
