//! A filter that is generic over simba's numbers, as crates of the field have it. It has quaternions by index, a matrix of 36
//! elements, and an interface whose methods return a reference in a `Result`.

use bessemer::nalgebra::{
    self, Matrix6, Quaternion, RealField, Scalar, SimdRealField, SimdValue, UnitQuaternion, Vector2, Vector3, Vector6,
};
use bessemer::prelude::*;

/// Reasons without a result.
#[data]
#[derive(Debug)]
pub enum Lost {
    Direction,
}

/// Operations of a filter.
#[interface]
pub trait Filter<N: Scalar + SimdValue> {
    /// Corrects the attitude by a direction.
    fn update(&mut self, rate: &Vector3<N>, direction: &Vector3<N>) -> Result<&UnitQuaternion<N>, Lost>;

    /// Integrates a rate.
    fn turn(&mut self, rate: &Vector3<N>) -> &UnitQuaternion<N>;
}

/// The attitude, and the integral of its error.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Attitude<N: Scalar + SimdValue + Copy> {
    period: N,
    integral: Vector3<N>,
    /// The attitude.
    pub quat: UnitQuaternion<N>,
}

#[data]
impl<N: SimdRealField + Copy> Attitude<N> {
    /// An attitude without turn.
    pub fn new(period: N) -> Self {
        Attitude::with(
            period,
            UnitQuaternion::new_unchecked(Quaternion::new(N::one(), N::zero(), N::zero(), N::zero())),
        )
    }

    /// An attitude from a quaternion.
    pub fn with(period: N, quat: UnitQuaternion<N>) -> Self {
        Attitude { period, integral: nalgebra::zero(), quat }
    }
}

#[data]
impl<N: RealField + Copy> Filter<N> for Attitude<N> {
    fn update(&mut self, rate: &Vector3<N>, direction: &Vector3<N>) -> Result<&UnitQuaternion<N>, Lost> {
        let q = self.quat.as_ref();
        let zero: N = nalgebra::zero();
        let half: N = nalgebra::convert(0.5);
        let Some(direction) = direction.try_normalize(zero) else {
            return Err(Lost::Direction);
        };
        let h = q * (Quaternion::from_parts(zero, direction) * q.conjugate());
        let b = Quaternion::new(zero, Vector2::new(h[0], h[1]).norm(), zero, h[2]);
        #[rustfmt::skip]
        let m = Matrix6::new(
            q[0], q[1], zero, b[0], b[2], half,
            q[2], q[3], zero, b[0], b[2], half,
            zero, zero, half, q[0], q[1], b[1],
            half, zero, zero, q[3], q[2], b[1],
            zero, half, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero
        );
        let v = Vector6::new(q[0], q[1], q[2], q[3], b[0], b[2]);
        let Some(step) = (m * v).try_normalize(zero) else {
            return Ok(self.turn(rate));
        };
        let dot = q * Quaternion::from_parts(zero, *rate) * half
            - Quaternion::new(step[0], step[1], step[2], step[3]) * half;
        self.integral += direction * self.period;
        self.quat = UnitQuaternion::from_quaternion(q + dot * self.period);
        Ok(&self.quat)
    }

    fn turn(&mut self, rate: &Vector3<N>) -> &UnitQuaternion<N> {
        let q = self.quat.as_ref();
        let half: N = nalgebra::convert(0.5);
        let dot = q * Quaternion::from_parts(nalgebra::zero(), *rate) * half;
        self.quat = UnitQuaternion::from_quaternion(q + dot * self.period);
        &self.quat
    }
}

#[function]
pub fn attitude(rate: [f64; 3], direction: [f64; 3]) -> ([f64; 4], f64, bool) {
    let mut filter = Attitude::new(0.01);
    let rate = Vector3::new(rate[0], rate[1], rate[2]);
    let direction = Vector3::new(direction[0], direction[1], direction[2]);
    let is_lost = filter.update(&rate, &direction).is_err();
    filter.turn(&rate);
    let q = filter.quat;
    ([q.w, q.i, q.j, q.k], filter.integral.x, is_lost)
}

#[function]
pub fn in_single(rate: [f32; 3]) -> [f32; 4] {
    let mut filter = Attitude::<f32>::new(0.01);
    let q = filter.turn(&Vector3::new(rate[0], rate[1], rate[2]));
    [q.w, q.i, q.j, q.k]
}
