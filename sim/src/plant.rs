//! The aircraft's motion (thesis, eqs. (2.18)–(2.29)): twelve states, a floor at z = 0.
//!
//! Knows loads, not motors; and nothing of who commands them.

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

/// Rotation from the body frame to the inertial frame (thesis, eq. (2.11)), as the product of three rotations.
pub fn rotation(angles: &Vector3<f64>) -> Matrix3<f64> {
    let (s1, c1) = angles.x.sin_cos();
    let (s2, c2) = angles.y.sin_cos();
    let (s3, c3) = angles.z.sin_cos();
    let roll = Matrix3::new(1.0, 0.0, 0.0, 0.0, c1, s1, 0.0, -s1, c1);
    let pitch = Matrix3::new(c2, 0.0, -s2, 0.0, 1.0, 0.0, s2, 0.0, c2);
    let yaw = Matrix3::new(c3, s3, 0.0, -s3, c3, 0.0, 0.0, 0.0, 1.0);
    roll * pitch * yaw
}

/// Rates of the Euler angles (thesis, eq. (2.17)), rad/s.
pub fn angle_rates(angles: &Vector3<f64>, rates: &Vector3<f64>) -> Vector3<f64> {
    let (s3, c3) = angles.z.sin_cos();
    let along = c3 * rates.x + s3 * rates.y;
    Vector3::new(
        -along / angles.y.cos(),
        s3 * rates.x - c3 * rates.y,
        -angles.y.tan() * along - rates.z,
    )
}

impl State {
    /// Returns true if every figure is finite.
    pub fn is_finite(&self) -> bool {
        self.vector().iter().all(|value| value.is_finite())
    }

    /// Derivative of every state (thesis, eqs. (2.17), (2.23), (2.24), (2.28), (2.29)).
    ///
    /// Sines take most of its time, so each is computed once, and of the rotation only the column that the thrust needs. The
    /// bits are those of [`rotation`] and [`angle_rates`].
    pub(crate) fn slope(&self, body: &Body, loads: &Loads) -> SVector<f64, 12> {
        let (s1, c1) = self.angles.x.sin_cos();
        let (s2, c2) = self.angles.y.sin_cos();
        let (s3, c3) = self.angles.z.sin_cos();
        let push = Vector3::new(-s2, s1 * c2, c1 * c2) * loads.thrust + loads.wind;
        let along = c3 * self.rates.x + s3 * self.rates.y;
        let angles = Vector3::new(
            -along / c2,
            s3 * self.rates.x - c3 * self.rates.y,
            -self.angles.y.tan() * along - self.rates.z,
        );
        let momentum = body.inertia.component_mul(&self.rates);
        let turn = loads.torque - self.rates.cross(&momentum);
        State {
            position: self.velocity,
            angles,
            velocity: push / body.mass - Vector3::new(0.0, 0.0, GRAVITY),
            rates: turn.component_div(&body.inertia),
        }
        .vector()
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
        State::from_vector(state).slope(self, &input.command)
    }

    fn end(&mut self, _: f64, state: &mut SVector<f64, 12>) {
        *state = State::from_vector(state).above_floor().vector();
    }
}
