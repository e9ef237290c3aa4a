//! Plans moves of several axes with trapezoidal velocity, all of which end at the same time.

use core::cmp::Ordering;
use core::ops::{Add, Mul};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    pub max_velocity: f64,
    pub max_acceleration: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Setpoint {
    pub position: f64,
    pub velocity: f64,
    pub acceleration: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    start: f64,
    direction: f64,
    t_accel: f64,
    t_cruise: f64,
    peak: f64,
    accel: f64,
}

impl Axis {
    pub fn plan(&self, from: f64, to: f64) -> Option<Profile> {
        if self.max_velocity <= 0.0 || self.max_acceleration <= 0.0 {
            return None;
        }
        let distance = (to - from).abs();
        let direction = (to - from).signum();
        let (v, a) = (self.max_velocity, self.max_acceleration);
        let (peak, t_cruise) = if distance * a < v * v {
            ((distance * a).sqrt(), 0.0)
        } else {
            (v, (distance - v * v / a) / v)
        };
        Some(Profile { start: from, direction, t_accel: peak / a, t_cruise, peak, accel: a })
    }
}

impl Profile {
    pub fn duration(&self) -> f64 {
        2.0 * self.t_accel + self.t_cruise
    }

    pub fn sample(&self, t: f64) -> Setpoint {
        let ramp = 0.5 * self.accel * self.t_accel * self.t_accel;
        let (s, v, a) = match t {
            t if t <= 0.0 => (0.0, 0.0, 0.0),
            t if t < self.t_accel => (0.5 * self.accel * t * t, self.accel * t, self.accel),
            t if t < self.t_accel + self.t_cruise => {
                (ramp + self.peak * (t - self.t_accel), self.peak, 0.0)
            }
            t if t < self.duration() => {
                let left = self.duration() - t;
                let total = 2.0 * ramp + self.peak * self.t_cruise;
                (total - 0.5 * self.accel * left * left, self.accel * left, -self.accel)
            }
            _ => (2.0 * ramp + self.peak * self.t_cruise, 0.0, 0.0),
        };
        Setpoint {
            position: self.start + self.direction * s,
            velocity: self.direction * v,
            acceleration: self.direction * a,
        }
    }

    /// The same move, slower.
    pub fn stretched(self, duration: f64) -> Profile {
        let own = self.duration();
        if own <= 0.0 || duration <= own {
            return self;
        }
        let k = own / duration;
        Profile {
            t_accel: self.t_accel / k,
            t_cruise: self.t_cruise / k,
            peak: self.peak * k,
            accel: self.accel * k * k,
            ..self
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planner<const N: usize> {
    axes: [Axis; N],
}

impl<const N: usize> Planner<N> {
    pub fn new(axes: [Axis; N]) -> Self {
        Planner { axes }
    }

    pub fn plan(&self, from: &[f64; N], to: &[f64; N]) -> Option<[Profile; N]> {
        let mut profiles = [None; N];
        for (i, axis) in self.axes.iter().enumerate() {
            profiles[i] = Some(axis.plan(from[i], to[i])?);
        }
        let slowest = profiles
            .iter()
            .flatten()
            .map(Profile::duration)
            .max_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal))?;
        let mut result = [Profile { start: 0.0, direction: 0.0, t_accel: 0.0, t_cruise: 0.0, peak: 0.0, accel: 0.0 }; N];
        for (slot, profile) in result.iter_mut().zip(profiles.into_iter().flatten()) {
            *slot = profile.stretched(slowest);
        }
        Some(result)
    }

    pub fn bottleneck(&self, from: &[f64; N], to: &[f64; N]) -> Option<usize> {
        (0..N)
            .filter_map(|i| self.axes[i].plan(from[i], to[i]).map(|p| (i, p.duration())))
            .max_by(|(_, a), (_, b)| a.total_cmp(b))
            .map(|(i, _)| i)
    }
}

pub fn blend<T: Copy + Add<Output = T> + Mul<f64, Output = T>>(a: T, b: T, t: f64) -> T {
    a * (1.0 - t) + b * t
}

impl Add for Setpoint {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Setpoint {
            position: self.position + o.position,
            velocity: self.velocity + o.velocity,
            acceleration: self.acceleration + o.acceleration,
        }
    }
}

impl Mul<f64> for Setpoint {
    type Output = Self;
    fn mul(self, k: f64) -> Self {
        Setpoint { position: self.position * k, velocity: self.velocity * k, acceleration: self.acceleration * k }
    }
}

pub fn two_axis(from: [f64; 2], to: [f64; 2], t: f64) -> Option<[Setpoint; 2]> {
    let planner = Planner::new([
        Axis { max_velocity: 2.0, max_acceleration: 4.0 },
        Axis { max_velocity: 1.0, max_acceleration: 1.5 },
    ]);
    let plans = planner.plan(&from, &to)?;
    let smooth = blend(plans[0].sample(t), plans[0].sample(t + 0.001), 0.5);
    let [_, second] = plans;
    Some([smooth, second.sample(t)])
}

pub fn slow_axis(from: [f64; 3], to: [f64; 3]) -> Option<usize> {
    let axis = Axis { max_velocity: 2.0, max_acceleration: 4.0 };
    Planner::new([axis, Axis { max_velocity: 0.5, ..axis }, axis]).bottleneck(&from, &to)
}
