//! Field-oriented current control: Clarke and Park transforms, two PI
//! controllers with decoupling, inverse Park to the modulator.

use core::ops::{Add, Mul, Sub};

/// Phase currents of two shunts; the third follows from Kirchhoff.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PhaseCurrents {
    pub a: f32,
    pub b: f32,
}

/// Stationary two-axis frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AlphaBeta {
    pub alpha: f32,
    pub beta: f32,
}

/// Rotor frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dq {
    pub d: f32,
    pub q: f32,
}

impl Add for Dq {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self { d: self.d + rhs.d, q: self.q + rhs.q }
    }
}

impl Sub for Dq {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self { d: self.d - rhs.d, q: self.q - rhs.q }
    }
}

impl Mul<f32> for Dq {
    type Output = Self;
    fn mul(self, k: f32) -> Self {
        Self { d: self.d * k, q: self.q * k }
    }
}

impl Dq {
    pub fn magnitude(self) -> f32 {
        self.d.hypot(self.q)
    }

    /// Shortens the vector to `limit`, keeping its direction.
    pub fn limited(self, limit: f32) -> Self {
        let m = self.magnitude();
        if m > limit { self * (limit / m) } else { self }
    }
}

impl From<PhaseCurrents> for AlphaBeta {
    /// Clarke transform, amplitude invariant.
    fn from(PhaseCurrents { a, b }: PhaseCurrents) -> Self {
        const INV_SQRT3: f32 = 0.577_350_26;
        Self { alpha: a, beta: (a + 2.0 * b) * INV_SQRT3 }
    }
}

/// Sine and cosine of the electrical angle, computed once per period.
#[derive(Clone, Copy, Debug)]
pub struct Rotor {
    sin: f32,
    cos: f32,
}

impl Rotor {
    pub fn at(angle: f32) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { sin, cos }
    }

    pub fn park(&self, v: AlphaBeta) -> Dq {
        Dq {
            d: self.cos * v.alpha + self.sin * v.beta,
            q: self.cos * v.beta - self.sin * v.alpha,
        }
    }

    pub fn inverse_park(&self, v: Dq) -> AlphaBeta {
        AlphaBeta {
            alpha: self.cos * v.d - self.sin * v.q,
            beta: self.sin * v.d + self.cos * v.q,
        }
    }
}

/// Motor constants used for tuning and decoupling.
#[derive(Clone, Copy, Debug)]
pub struct Motor {
    pub resistance: f32,
    pub inductance: f32,
    pub flux: f32,
}

#[derive(Clone, Debug)]
pub struct CurrentController {
    motor: Motor,
    kp: f32,
    ki_dt: f32,
    integral: Dq,
}

impl CurrentController {
    /// Tunes by pole-zero cancellation for the given closed-loop bandwidth.
    pub fn new(motor: Motor, bandwidth_rad: f32, dt: f32) -> Self {
        debug_assert!(motor.inductance > 0.0 && dt > 0.0);
        Self {
            motor,
            kp: motor.inductance * bandwidth_rad,
            ki_dt: motor.resistance * bandwidth_rad * dt,
            integral: Dq::default(),
        }
    }

    pub fn step(
        &mut self,
        target: Dq,
        phases: PhaseCurrents,
        angle: f32,
        speed: f32,
        v_max: f32,
    ) -> AlphaBeta {
        let rotor = Rotor::at(angle);
        let current = rotor.park(phases.into());
        let error = target - current;

        let Motor { inductance, flux, .. } = self.motor;
        let decoupling = Dq {
            d: -speed * inductance * current.q,
            q: speed * (inductance * current.d + flux),
        };
        let wanted = error * self.kp + self.integral + decoupling;
        let applied = wanted.limited(v_max);
        if applied == wanted {
            self.integral = self.integral + error * self.ki_dt;
        }
        rotor.inverse_park(applied)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOTOR: Motor = Motor { resistance: 0.2, inductance: 4e-4, flux: 0.01 };

    #[test]
    fn transforms_are_inverse() {
        let rotor = Rotor::at(0.7);
        let v = AlphaBeta { alpha: 1.5, beta: -0.4 };
        let back = rotor.inverse_park(rotor.park(v));
        assert!((back.alpha - v.alpha).abs() < 1e-6 && (back.beta - v.beta).abs() < 1e-6);
    }

    #[test]
    fn current_follows_on_a_spinning_motor() {
        let dt = 5e-5;
        let speed = 200.0;
        let mut ctl = CurrentController::new(MOTOR, 1500.0, dt);
        let (mut i, mut angle) = (Dq::default(), 0.0);
        let target = Dq { d: 0.0, q: 8.0 };
        for _ in 0..1000 {
            let rotor = Rotor::at(angle);
            let ab = rotor.inverse_park(i);
            let phases =
                PhaseCurrents { a: ab.alpha, b: -0.5 * ab.alpha + 0.866_025_4 * ab.beta };
            let v = rotor.park(ctl.step(target, phases, angle, speed, 14.0));
            let l = MOTOR.inductance;
            i = i + Dq {
                d: v.d - MOTOR.resistance * i.d + speed * l * i.q,
                q: v.q - MOTOR.resistance * i.q - speed * (l * i.d + MOTOR.flux),
            } * (dt / l);
            angle = (angle + speed * dt) % core::f32::consts::TAU;
        }
        assert!((i - target).magnitude() < 0.05, "{i:?}");
    }

    #[test]
    fn voltage_is_limited() {
        let mut ctl = CurrentController::new(MOTOR, 5000.0, 1e-4);
        let v = ctl.step(Dq { d: 0.0, q: 100.0 }, PhaseCurrents::default(), 1.0, 0.0, 12.0);
        assert!((v.alpha.hypot(v.beta) - 12.0).abs() < 1e-3);
    }
}
