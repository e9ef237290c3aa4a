//! Field-oriented current control of a three-phase motor.

use core::ops::{Add, Mul, Sub};
use nalgebra::ComplexField;

const SQRT_3: f32 = 1.732_050_8;

#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Abc {
    pub a: f32,
    pub b: f32,
    pub c: f32,
}

/// Stator-fixed frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AlphaBeta {
    pub alpha: f32,
    pub beta: f32,
}

/// Rotor-fixed frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Dq {
    pub d: f32,
    pub q: f32,
}

impl Abc {
    fn map(self, f: impl Fn(f32) -> f32) -> Self {
        Self { a: f(self.a), b: f(self.b), c: f(self.c) }
    }
}

/// Amplitude-invariant Clarke transform.
impl From<Abc> for AlphaBeta {
    fn from(Abc { a, b, c }: Abc) -> Self {
        Self { alpha: (2.0 * a - b - c) / 3.0, beta: (b - c) / SQRT_3 }
    }
}

impl From<AlphaBeta> for Abc {
    fn from(AlphaBeta { alpha, beta }: AlphaBeta) -> Self {
        let (x, y) = (-0.5 * alpha, 0.5 * SQRT_3 * beta);
        Self { a: alpha, b: x + y, c: x - y }
    }
}

/// Electrical angle with its sine and cosine, computed once per cycle.
#[derive(Debug, Clone, Copy)]
pub struct Rotation {
    sin: f32,
    cos: f32,
}

impl Rotation {
    pub fn new(angle: f32) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { sin, cos }
    }

    pub fn park(&self, v: AlphaBeta) -> Dq {
        Dq { d: self.cos * v.alpha + self.sin * v.beta, q: self.cos * v.beta - self.sin * v.alpha }
    }

    pub fn inverse_park(&self, v: Dq) -> AlphaBeta {
        AlphaBeta { alpha: self.cos * v.d - self.sin * v.q, beta: self.sin * v.d + self.cos * v.q }
    }
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
    /// Limits the length; the d axis has priority as it holds the flux.
    fn limit(self, length: f32) -> Self {
        let d = self.d.clamp(-length, length);
        let q_max = (length * length - d * d).max(0.0).sqrt();
        Self { d, q: self.q.clamp(-q_max, q_max) }
    }
}

/// Space-vector modulation by min-max injection; duty cycles in 0..=1.
pub fn space_vector(voltage: AlphaBeta, bus: f32) -> Abc {
    let phases = Abc::from(voltage);
    let Abc { a, b, c } = phases;
    let centre = 0.5 * (a.min(b).min(c) + a.max(b).max(c));
    phases.map(|v| (0.5 + (v - centre) / bus).clamp(0.0, 1.0))
}

#[derive(Debug, Clone, Copy)]
pub struct Motor {
    pub resistance: f32,
    pub inductance: f32,
    pub flux: f32,
}

/// Two PI current controllers with decoupling and back-calculation.
#[derive(Debug, Clone)]
pub struct CurrentController {
    motor: Motor,
    kp: f32,
    ki: f32,
    integral: Dq,
}

impl CurrentController {
    /// Cancels the motor's pole; `bandwidth` in rad/s.
    pub fn new(motor: Motor, bandwidth: f32) -> Self {
        Self {
            motor,
            kp: bandwidth * motor.inductance,
            ki: bandwidth * motor.resistance,
            integral: Dq::default(),
        }
    }

    /// Voltage for the next cycle, within the linear range of the inverter.
    pub fn update(&mut self, target: Dq, current: Dq, speed: f32, bus: f32, dt: f32) -> Dq {
        let Motor { inductance, flux, .. } = self.motor;
        let decoupling =
            Dq { d: -speed * inductance * current.q, q: speed * (inductance * current.d + flux) };
        let error = target - current;
        let wanted = error * self.kp + self.integral + decoupling;
        let voltage = wanted.limit(bus / SQRT_3);

        let excess = (wanted - voltage) * self.kp.recip();
        self.integral = self.integral + (error - excess) * (self.ki * dt);
        voltage
    }
}
