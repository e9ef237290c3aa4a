//! Field-oriented current control with decoupling, in the rotor's frame.
use bessemer::prelude::*;

/// A vector in the rotor's frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dq {
    pub d: f32,
    pub q: f32,
}

#[data]
impl Dq {
    pub const ZERO: Dq = Dq { d: 0.0, q: 0.0 };

    fn plus(self, other: Dq) -> Dq {
        Dq { d: self.d + other.d, q: self.q + other.q }
    }

    fn magnitude(&self) -> f32 {
        self.d.hypot(self.q)
    }

    fn map(self, f: impl Fn(f32) -> f32) -> Dq {
        Dq { d: f(self.d), q: f(self.q) }
    }

    fn limited(self, most: f32) -> (Dq, bool) {
        let length = self.magnitude();
        if length > most { (self.map(|x| x * most / length), true) } else { (self, false) }
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motor {
    #[unit("Ω")]
    pub resistance: f32,
    #[unit("H")]
    pub inductance: Dq,
    #[unit("Wb")]
    pub flux: f32,
    pub pole_pairs: u8,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pi {
    pub p: f32,
    pub i: f32,
    pub sum: f32,
}

#[data]
impl Pi {
    fn step(&mut self, error: f32, frozen: bool, dt: f32) -> f32 {
        if !frozen {
            self.sum += self.i * error * dt;
        }
        self.p * error + self.sum
    }
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurrentControl {
    motor: Motor,
    d: Pi,
    q: Pi,
    saturated: bool,
}

#[component]
impl CurrentControl {
    const DT: f32 = 1.0 / 20_000.0;

    #[entry(infallible)]
    pub fn step(&mut self, wanted: Dq, currents: [f32; 3], angle: f32, speed: f32, supply: f32) -> [f32; 3] {
        let [a, b, c] = currents;
        let alpha = (2.0 * a - b - c) / 3.0;
        let beta = (b - c) / 3f32.sqrt();
        let (sin, cos) = angle.sin_cos();
        let measured = Dq { d: alpha * cos + beta * sin, q: -alpha * sin + beta * cos };
        let electrical = speed * f32::from(self.motor.pole_pairs);
        let decoupling = Dq {
            d: -electrical * self.motor.inductance.q * measured.q,
            q: electrical * (self.motor.inductance.d * measured.d + self.motor.flux),
        };
        let frozen = self.saturated;
        let pi = Dq {
            d: self.d.step(wanted.d - measured.d, frozen, Self::DT),
            q: self.q.step(wanted.q - measured.q, frozen, Self::DT),
        };
        let (voltage, saturated) = pi.plus(decoupling).limited(supply / 3f32.sqrt());
        self.saturated = saturated;
        let v_alpha = voltage.d * cos - voltage.q * sin;
        let v_beta = voltage.d * sin + voltage.q * cos;
        let phases = [v_alpha, -0.5 * v_alpha + 0.75f32.sqrt() * v_beta, -0.5 * v_alpha - 0.75f32.sqrt() * v_beta];
        let middle = 0.5 * (phases.iter().copied().fold(f32::MIN, f32::max) + phases.iter().copied().fold(f32::MAX, f32::min));
        phases.map(|v| ((v - middle) / supply.max(1.0) + 0.5).clamp(0.0, 1.0))
    }
}
