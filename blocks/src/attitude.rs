//! Attitude: control by quaternions, and the estimators of Mahony and of Madgwick.
//!
//! An attitude is the rotation from the body's frame to the world's, whose z axis points up. A gyroscope
//! measures the rates of the body in its own frame, rad/s; an accelerometer the specific force, which points up at rest, in any
//! unit. The heading has no reference, so it drifts with the gyroscope.

use bessemer::prelude::*;

/// Attitude error as a rotation vector to first order, in the body's frame, rad. It is twice the imaginary part of the
/// rotation from `attitude` to `target`, by the shorter way.
///
/// ```
/// use bessemer_blocks::attitude_error;
/// use bessemer::nalgebra::{Quaternion, UnitQuaternion};
///
/// let turned = UnitQuaternion::new_unchecked(Quaternion::new(-1.0, 0.0, 0.0, -0.05));
/// assert_eq!(attitude_error(&UnitQuaternion::identity(), &turned).z, 0.1);
/// ```
#[function]
pub fn attitude_error<T: Real>(
    attitude: &UnitQuaternion<T>,
    target: &UnitQuaternion<T>,
) -> Vector3<T> {
    let error = attitude.inverse() * target;
    let sign = if error.w < T::ZERO { real::<T>(-2.0) } else { real::<T>(2.0) };
    Vector3::new(error.i * sign, error.j * sign, error.k * sign)
}

/// Gains of [`attitude_torque`], and the body's inertia.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttitudeGains<T> {
    /// Torque for an error, 0 or more, N·m/rad.
    pub stiffness: Vector3<T>,
    /// Torque for an error of the rates, 0 or more, N·m·s/rad.
    pub damping: Vector3<T>,
    /// Inertia of the body about its centre of mass, kg·m².
    pub inertia: Matrix3<T>,
}

impl<T: Real> Default for AttitudeGains<T> {
    fn default() -> Self {
        AttitudeGains {
            stiffness: Vector3::zeros(),
            damping: Vector3::zeros(),
            inertia: Matrix3::identity(),
        }
    }
}

/// Attitude control: the torque that cycles a body to a target, N·m.
///
/// τ = K e − D (ω − ω*) + ω × J ω, with the error e of [`attitude_error`]. Nothing saturates; with a state that is not
/// finite, the torque is not. Source: Wie, Weiss and Arapostathis, *Quaternion Feedback Regulator for Spacecraft
/// Eigenaxis Rotations*, Journal of Guidance, Control, and Dynamics 12 (3), 1989.
///
/// ```
/// use bessemer_blocks::{AttitudeGains, attitude_torque};
/// use bessemer::nalgebra::{UnitQuaternion, Vector3};
///
/// let gains = AttitudeGains { damping: Vector3::repeat(0.5), ..AttitudeGains::default() };
/// let (level, rates) = (UnitQuaternion::identity(), Vector3::new(0.0, 0.0, 2.0));
/// assert_eq!(attitude_torque(&gains, &level, &rates, &level, &Vector3::zeros()).z, -1.0);
/// ```
#[function]
pub fn attitude_torque<T: Real>(
    gains: &AttitudeGains<T>,
    attitude: &UnitQuaternion<T>,
    rates: &Vector3<T>,
    target: &UnitQuaternion<T>,
    target_rates: &Vector3<T>,
) -> Vector3<T> {
    let error = attitude_error(attitude, target);
    let gyroscopic = rates.cross(&(gains.inertia * rates));
    gains.stiffness.component_mul(&error) - gains.damping.component_mul(&(rates - target_rates))
        + gyroscopic
}

/// Returns the direction of up in the body's frame.
#[function]
pub(crate) fn up<T: Real>(attitude: &UnitQuaternion<T>) -> Vector3<T> {
    let (w, x, y, z) = (attitude.w, attitude.i, attitude.j, attitude.k);
    let two = real::<T>(2.0);
    Vector3::new(two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z)
}

/// Returns an attitude changed by a rate of its quaternion in a period, of length 1 again.
#[function]
fn moved<T: Real>(attitude: &UnitQuaternion<T>, change: Quaternion<T>) -> UnitQuaternion<T> {
    let moved = attitude.into_inner() + change;
    if moved.norm_squared().is_finite() {
        UnitQuaternion::from_quaternion(moved)
    } else {
        *attitude
    }
}

/// Gains of a [`Mahony`] filter.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MahonyGains<T> {
    /// Rate at which the attitude follows the accelerometer, about 1, 0 or more.
    #[unit("1/s")]
    pub proportional: T,
    /// Rate of the bias, about 0.1, 0 or more.
    #[unit("1/s²")]
    pub integral: T,
    /// Period, above 0.
    #[unit("s")]
    pub period: T,
}

/// Mahony's attitude filter: gyroscope and accelerometer, with an estimate of the gyroscope's bias.
///
/// With the measured direction of up a, the estimated one v and e = a × v: bias −= h ki e, and
/// q += h/2 q ⊗ (ω − bias + kp e), of length 1 again. A force of 0 gives e = 0; samples that are not finite are ignored.
/// Initialisation: `Default` is level, without bias. Source: Mahony, Hamel and Pflimlin, *Nonlinear Complementary
/// Filters on the Special Orthogonal Group*, IEEE Transactions on Automatic Control 53 (5), 2008, equation (48).
///
/// ```
/// use bessemer_blocks::{Mahony, MahonyGains};
/// use bessemer::nalgebra::Vector3;
///
/// let gains = MahonyGains { proportional: 2.0, integral: 0.0, period: 0.01_f64 };
/// let mut filter = Mahony::default();
/// let tilted = Vector3::new(0.0, 0.6, 0.8);
/// for _ in 0..2000 {
///     filter.step(&gains, &Vector3::zeros(), &tilted);
/// }
/// assert!((filter.up() - tilted).norm() < 1e-6);
/// ```
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mahony<T: Real> {
    /// The attitude.
    attitude: UnitQuaternion<T>,
    /// Bias of the gyroscope.
    #[unit("rad/s")]
    bias: Vector3<T>,
}

impl<T: Real> Default for Mahony<T> {
    fn default() -> Self {
        Mahony { attitude: UnitQuaternion::identity(), bias: Vector3::zeros() }
    }
}

#[component]
impl<T: Real> Mahony<T> {
    /// Takes one sample of rates, rad/s, and force, in any unit; returns the attitude.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        gains: &MahonyGains<T>,
        rates: &Vector3<T>,
        force: &Vector3<T>,
    ) -> UnitQuaternion<T> {
        let length = force.norm();
        let error = if length > T::ZERO && length.is_finite() {
            (force / length).cross(&up(&self.attitude))
        } else {
            Vector3::zeros()
        };
        let bias = self.bias - error * (gains.integral * gains.period);
        let rates = rates - bias + error * gains.proportional;
        if rates.norm_squared().is_finite() {
            self.bias = bias;
            let half = rates * (real::<T>(0.5) * gains.period);
            let change = self.attitude.into_inner() * Quaternion::from_imag(half);
            self.attitude = moved(&self.attitude, change);
        }
        self.attitude
    }

    /// Returns the direction of up in the body's frame.
    #[entry(infallible)]
    pub fn up(&self) -> Vector3<T> {
        up(&self.attitude)
    }
}

/// Gain of a [`Madgwick`] filter.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MadgwickGain<T> {
    /// Rate β of the correction, about 0.03 to 0.1, 0 or more.
    #[unit("rad/s")]
    pub gain: T,
    /// Period, above 0.
    #[unit("s")]
    pub period: T,
}

/// Madgwick's attitude filter: gyroscope and accelerometer, by a step of gradient descent in each period.
///
/// q += h (½ q ⊗ ω − β ∇f/|∇f|), of length 1 again, for f = |v − a|²/2 with the measured direction of up a and the
/// estimated one v. A force of 0 or a gradient of 0 gives no correction; samples that are not finite are ignored.
/// Initialisation: `Default` is level. Source: Madgwick, Harrison and Vaidyanathan, *Estimation of IMU and MARG
/// Orientation Using a Gradient Descent Algorithm*, ICORR 2011.
///
/// ```
/// use bessemer_blocks::{Madgwick, MadgwickGain};
/// use bessemer::nalgebra::Vector3;
///
/// let gain = MadgwickGain { gain: 0.1, period: 0.01_f64 };
/// let mut filter = Madgwick::default();
/// for _ in 0..2000 {
///     filter.step(&gain, &Vector3::zeros(), &Vector3::new(0.0, 0.6, 0.8));
/// }
/// assert!((filter.up().y - 0.6).abs() < 2e-3);
/// ```
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Madgwick<T: Real> {
    /// The attitude.
    attitude: UnitQuaternion<T>,
}

impl<T: Real> Default for Madgwick<T> {
    fn default() -> Self {
        Madgwick { attitude: UnitQuaternion::identity() }
    }
}

#[component]
impl<T: Real> Madgwick<T> {
    /// Takes one sample of rates, rad/s, and force, in any unit; returns the attitude.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        gain: &MadgwickGain<T>,
        rates: &Vector3<T>,
        force: &Vector3<T>,
    ) -> UnitQuaternion<T> {
        let half = rates * (real::<T>(0.5) * gain.period);
        let mut change = self.attitude.into_inner() * Quaternion::from_imag(half);
        let length = force.norm();
        if length > T::ZERO && length.is_finite() {
            let downhill = gradient(&self.attitude, &(force / length));
            let steepness = downhill.norm();
            if steepness > T::ZERO {
                change -= downhill * (gain.gain * gain.period / steepness);
            }
        }
        self.attitude = moved(&self.attitude, change);
        self.attitude
    }

    /// Returns the direction of up in the body's frame.
    #[entry(infallible)]
    pub fn up(&self) -> Vector3<T> {
        up(&self.attitude)
    }
}

/// Returns the gradient of |v − a|²/2 by the quaternion, for a measured direction a.
#[function]
fn gradient<T: Real>(attitude: &UnitQuaternion<T>, measured: &Vector3<T>) -> Quaternion<T> {
    let (w, x, y, z) = (attitude.w, attitude.i, attitude.j, attitude.k);
    let (two, four) = (real::<T>(2.0), real::<T>(4.0));
    let f = up(attitude) - measured;
    Quaternion::new(
        two * (x * f.y - y * f.x),
        two * (z * f.x + w * f.y) - four * x * f.z,
        two * (z * f.y - w * f.x) - four * y * f.z,
        two * (x * f.x + y * f.y),
    )
}
