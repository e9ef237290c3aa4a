//! Adaptive notch filter: a second-order notch with constrained poles whose
//! frequency follows the strongest tone by a normalised gradient.

use core::f32::consts::{PI, TAU};

/// Frequency in hertz.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Hertz(pub f32);

impl Hertz {
    fn to_omega(self, fs: Self) -> f32 {
        TAU * self.0 / fs.0
    }

    fn from_omega(omega: f32, fs: Self) -> Self {
        Self(omega / TAU * fs.0)
    }
}

#[derive(Clone, Copy, Debug)]
pub struct NotchConfig {
    pub sample_rate: Hertz,
    pub start: Hertz,
    /// Range within which the notch may wander.
    pub range: (Hertz, Hertz),
    /// Pole radius: nearer to one is narrower and slower.
    pub pole_radius: f32,
    pub step_size: f32,
}

impl Default for NotchConfig {
    fn default() -> Self {
        Self {
            sample_rate: Hertz(1000.0),
            start: Hertz(100.0),
            range: (Hertz(40.0), Hertz(400.0)),
            pole_radius: 0.95,
            step_size: 0.004,
        }
    }
}

/// Output of one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotchOutput {
    pub cleaned: f32,
    pub tone: f32,
    pub frequency: Hertz,
    /// Whether the notch is sitting on a tone.
    pub locked: bool,
}

#[derive(Clone, Debug)]
pub struct AdaptiveNotch {
    fs: Hertz,
    /// Limits of the coefficient `a = 2 cos(omega)`.
    a_min: f32,
    a_max: f32,
    a: f32,
    r: f32,
    mu: f32,
    /// State of the all-pole part, newest first.
    s: [f32; 2],
    /// Running powers: of the gradient, the input and the output.
    gradient_power: f32,
    input_power: f32,
    output_power: f32,
}

impl AdaptiveNotch {
    const FORGET: f32 = 0.98;
    /// Output to input power below which the notch counts as locked.
    const LOCK_RATIO: f32 = 0.3;
    const FLOOR: f32 = 1e-9;

    /// `None` when the range is not within 0 and Nyquist or the radius not in (0, 1).
    pub fn new(cfg: NotchConfig) -> Option<Self> {
        let fs = cfg.sample_rate;
        let (low, high) = cfg.range;
        let range_ok = low.0 > 0.0 && low < high && high.to_omega(fs) < PI;
        if !range_ok || !(cfg.pole_radius > 0.0 && cfg.pole_radius < 1.0) {
            return None;
        }
        let [a_max, a_min, a] = [low, high, cfg.start].map(|f| 2.0 * f.to_omega(fs).cos());
        Some(Self {
            fs,
            a_min,
            a_max,
            a: a.clamp(a_min, a_max),
            r: cfg.pole_radius,
            mu: cfg.step_size,
            s: [0.0; 2],
            gradient_power: 1.0,
            input_power: 0.0,
            output_power: 0.0,
        })
    }

    pub fn step(&mut self, x: f32) -> NotchOutput {
        let [s1, s2] = self.s;
        let s0 = x + self.r * self.a * s1 - self.r * self.r * s2;
        let cleaned = s0 - self.a * s1 + s2;
        self.s = [s0, s1];

        // d cleaned / d a, the poles taken as fixed.
        let gradient = -s1;
        let track = |power: &mut f32, v: f32| {
            *power = Self::FORGET * *power + (1.0 - Self::FORGET) * v * v;
            *power
        };
        let norm = track(&mut self.gradient_power, gradient);
        let input = track(&mut self.input_power, x);
        let output = track(&mut self.output_power, cleaned);

        if norm > Self::FLOOR {
            let wanted = self.a - self.mu * cleaned * gradient / norm;
            if wanted.is_finite() {
                self.a = wanted.clamp(self.a_min, self.a_max);
            }
        }
        NotchOutput {
            cleaned,
            tone: x - cleaned,
            frequency: self.frequency(),
            locked: input > Self::FLOOR && output < Self::LOCK_RATIO * input,
        }
    }

    pub fn frequency(&self) -> Hertz {
        Hertz::from_omega((0.5 * self.a).acos(), self.fs)
    }
}

impl Default for AdaptiveNotch {
    fn default() -> Self {
        // The default configuration is a valid one, so the fallback never runs.
        Self::new(NotchConfig::default()).unwrap_or(Self {
            fs: Hertz(1000.0),
            a_min: -2.0,
            a_max: 2.0,
            a: 0.0,
            r: 0.9,
            mu: 0.0,
            s: [0.0; 2],
            gradient_power: 1.0,
            input_power: 0.0,
            output_power: 0.0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs a tone of the given frequency, with the phase carried over calls.
    fn feed(notch: &mut AdaptiveNotch, freq: f32, samples: u32) -> Option<NotchOutput> {
        (0..samples)
            .map(|n| notch.step(2.0 * (TAU * freq * n as f32 / 1000.0).sin()))
            .last()
    }

    #[test]
    fn locks_and_follows() {
        let mut notch = AdaptiveNotch::default();
        for target in [150.0, 180.0, 120.0] {
            let out = feed(&mut notch, target, 4000).unwrap();
            assert!((out.frequency.0 - target).abs() < 1.0, "{target}: {out:?}");
            assert!(out.locked && out.cleaned.abs() < 0.1);
        }
    }

    #[test]
    fn stays_in_range_and_out_of_lock() {
        let mut notch = AdaptiveNotch::default();
        let out = feed(&mut notch, 20.0, 5000).unwrap();
        assert!(out.frequency >= Hertz(39.9) && !out.locked, "{out:?}");
        notch.step(f32::NAN);
        assert!(notch.frequency().0.is_finite());
    }

    #[test]
    fn bad_configurations() {
        let base = NotchConfig::default();
        let beyond = NotchConfig { range: (Hertz(40.0), Hertz(600.0)), ..base };
        let unstable = NotchConfig { pole_radius: 1.0, ..base };
        assert!([beyond, unstable].into_iter().all(|cfg| AdaptiveNotch::new(cfg).is_none()));
    }
}
