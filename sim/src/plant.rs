//! The aircraft's motion (thesis, eqs. (2.18)–(2.29)): twelve states, a floor at z = 0.
//!
//! Its sines are those of `bessemer-lanes`: those of a C library differ from version to version, and with them the flight of a
//! seed.
//!
//! Knows loads, not motors; and nothing of who commands them.

use bessemer_lanes::{Number, sin_cos};
use bessemer_sim::{Input, Plant};
use nalgebra::{Matrix3, SVector, Vector3};

/// Acceleration of gravity, m/s².
pub const GRAVITY: f64 = 9.81;

/// Position, attitude and their rates (thesis, eq. (2.18)).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Position in the inertial frame, z upwards, m.
    pub position: Vector3<f64>,
    /// Euler angles: roll, pitch, yaw, rad.
    pub angles: Vector3<f64>,
    /// Velocity in the inertial frame, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity in the body frame, rad/s.
    pub rates: Vector3<f64>,
}

/// Forces and torques on the aircraft, constant over one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Loads {
    /// Thrust of the motors along the body's z, N.
    pub thrust: f64,
    /// Torque about the body's axes, N·m.
    pub torque: Vector3<f64>,
    /// Force of the air in the inertial frame, N.
    pub wind: Vector3<f64>,
}

/// A rigid body: its mass and inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Mass, kg.
    pub mass: f64,
    /// Moments of inertia about the body axes, kg·m².
    pub inertia: Vector3<f64>,
}

/// Rotation from the body frame to the inertial frame (thesis, eq. (2.11)).
pub fn rotation(angles: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::from_row_slice(&rotation_of((*angles).into()).concat())
}

/// Returns the rows of the [`rotation`], the product of one about each axis.
pub(crate) fn rotation_of<T: Number>([roll, pitch, yaw]: [T; 3]) -> [[T; 3]; 3] {
    let ((s1, c1), (s2, c2), (s3, c3)) = (sin_cos(roll), sin_cos(pitch), sin_cos(yaw));
    let (along, across) = (s1 * s2, c1 * s2);
    [
        [c2 * c3, c2 * s3, -s2],
        [along * c3 - c1 * s3, along * s3 + c1 * c3, s1 * c2],
        [across * c3 + s1 * s3, across * s3 - s1 * c3, c1 * c2],
    ]
}

/// Rates of the Euler angles (thesis, eq. (2.17)), rad/s.
pub fn angle_rates(angles: &Vector3<f64>, rates: &Vector3<f64>) -> Vector3<f64> {
    let (s3, c3) = sin_cos(angles.z);
    let (s2, c2) = sin_cos(angles.y);
    let along = (c3 * rates.x + s3 * rates.y) / c2;
    Vector3::new(-along, s3 * rates.x - c3 * rates.y, -s2 * along - rates.z)
}

/// A rigid body as its equations of motion need it: in them a product costs less than a quotient.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rigid<T> {
    /// Moments of inertia about the body axes, kg·m².
    inertia: [T; 3],
    /// Acceleration per force, 1/kg.
    per_force: T,
    /// Angular acceleration per torque about each axis, 1/(kg·m²).
    per_torque: [T; 3],
}

impl<T: Number> Rigid<T> {
    /// Creates a body of a mass, kg, and moments of inertia, kg·m².
    pub fn new(mass: T, inertia: [T; 3]) -> Self {
        let inverse = |value: T| T::of(1.0) / value;
        Self { inertia, per_force: inverse(mass), per_torque: inertia.map(inverse) }
    }

    /// Returns the derivative of the twelve states under a thrust, N, a torque, N·m, and the force of the wind, N. See the
    /// thesis, eqs. (2.17), (2.23), (2.24), (2.28), (2.29).
    ///
    /// Sines take most of its time, so each is computed once, and of the [`rotation`] only the column that the thrust needs.
    #[inline]
    pub fn slope(&self, state: &[T; 12], thrust: T, torque: [T; 3], wind: [T; 3]) -> [T; 12] {
        let [_, _, _, roll, pitch, yaw, vx, vy, vz, p, q, r] = *state;
        let ((s1, c1), (s2, c2), (s3, c3)) = (sin_cos(roll), sin_cos(pitch), sin_cos(yaw));
        let push = [-s2 * thrust, s1 * c2 * thrust, c1 * c2 * thrust];
        let pull = |axis: usize| (push[axis] + wind[axis]) * self.per_force;
        let momentum = [self.inertia[0] * p, self.inertia[1] * q, self.inertia[2] * r];
        let turn = [
            torque[0] - (q * momentum[2] - r * momentum[1]),
            torque[1] - (r * momentum[0] - p * momentum[2]),
            torque[2] - (p * momentum[1] - q * momentum[0]),
        ];
        let along = (c3 * p + s3 * q) / c2;
        let [x, y, z] = self.per_torque;
        [
            vx,
            vy,
            vz,
            -along,
            s3 * p - c3 * q,
            -s2 * along - r,
            pull(0),
            pull(1),
            pull(2) - T::of(GRAVITY),
            turn[0] * x,
            turn[1] * y,
            turn[2] * z,
        ]
    }
}

impl Body {
    /// Returns the body for its equations of motion.
    pub(crate) fn rigid(&self) -> Rigid<f64> {
        Rigid::new(self.mass, self.inertia.into())
    }
}

impl State {
    /// Returns true if every figure is finite.
    pub fn is_finite(&self) -> bool {
        self.vector().iter().all(|value| value.is_finite())
    }

    /// Returns the derivative of every state of a body under loads.
    pub(crate) fn slope(&self, body: &Rigid<f64>, loads: &Loads) -> SVector<f64, 12> {
        let Loads { thrust, torque, wind } = *loads;
        body.slope(&self.vector().data.0[0], thrust, torque.into(), wind.into()).into()
    }

    /// Applies the floor: the aircraft rests on it until its thrust lifts it.
    pub(crate) fn above_floor(self) -> State {
        if self.position.z > 0.0 || self.velocity.z > 0.0 {
            return self;
        }
        State {
            position: Vector3::new(self.position.x, self.position.y, 0.0),
            angles: self.angles,
            ..State::default()
        }
    }

    /// Returns the twelve numbers in their order.
    pub fn vector(&self) -> SVector<f64, 12> {
        let mut all = SVector::<f64, 12>::zeros();
        let parts = [self.position, self.angles, self.velocity, self.rates];
        for (n, part) in parts.iter().enumerate() {
            all.fixed_rows_mut::<3>(3 * n).copy_from(part);
        }
        all
    }

    /// Returns the state of the twelve numbers.
    pub fn from_vector(all: &SVector<f64, 12>) -> State {
        let part = |n: usize| all.fixed_rows::<3>(3 * n).into_owned();
        State { position: part(0), angles: part(1), velocity: part(2), rates: part(3) }
    }
}

/// The body alone, driven by its loads.
impl Plant<12> for Body {
    type Command = Loads;
    type Disturbance = ();

    fn derivative(
        &self,
        _: f64,
        state: &SVector<f64, 12>,
        input: &Input<Loads, ()>,
    ) -> SVector<f64, 12> {
        State::from_vector(state).slope(&self.rigid(), &input.command)
    }

    fn end(&mut self, _: f64, state: &mut SVector<f64, 12>) {
        *state = State::from_vector(state).above_floor().vector();
    }
}
