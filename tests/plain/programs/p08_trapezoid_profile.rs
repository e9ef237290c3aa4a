//! Trapezoidal motion profile for one axis, with an iterator over its samples
//! and an executor that can be given a new target on the fly when at rest.

/// Position, velocity and acceleration wanted at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Setpoint {
    pub position: f32,
    pub velocity: f32,
    pub acceleration: f32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    Accelerating,
    Cruising,
    Braking,
    Done,
}

/// A planned move from `start` to `start + distance`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile {
    start: f32,
    direction: f32,
    accel: f32,
    peak_velocity: f32,
    t_ramp: f32,
    t_cruise: f32,
}

impl Profile {
    /// Plans a move; `None` unless both limits are positive.
    pub fn plan(start: f32, end: f32, v_max: f32, a_max: f32) -> Option<Self> {
        if !(v_max > 0.0 && a_max > 0.0) {
            return None;
        }
        let distance = (end - start).abs();
        // Where the ramps alone would overshoot the distance it is a triangle.
        let peak_velocity = v_max.min((distance * a_max).sqrt());
        let t_ramp = peak_velocity / a_max;
        let t_cruise = if peak_velocity > 0.0 {
            (distance / peak_velocity - t_ramp).max(0.0)
        } else {
            0.0
        };
        Some(Self {
            start,
            direction: (end - start).signum(),
            accel: a_max,
            peak_velocity,
            t_ramp,
            t_cruise,
        })
    }

    pub fn duration(&self) -> f32 {
        2.0 * self.t_ramp + self.t_cruise
    }

    pub fn phase(&self, t: f32) -> Phase {
        match t {
            t if t < self.t_ramp => Phase::Accelerating,
            t if t < self.t_ramp + self.t_cruise => Phase::Cruising,
            t if t < self.duration() => Phase::Braking,
            _ => Phase::Done,
        }
    }

    pub fn at(&self, t: f32) -> Setpoint {
        let t = t.max(0.0);
        let ramp_distance = 0.5 * self.peak_velocity * self.t_ramp;
        let (s, v, a) = match self.phase(t) {
            Phase::Accelerating => (0.5 * self.accel * t * t, self.accel * t, self.accel),
            Phase::Cruising => {
                (ramp_distance + self.peak_velocity * (t - self.t_ramp), self.peak_velocity, 0.0)
            }
            Phase::Braking => {
                let left = self.duration() - t;
                (self.length() - 0.5 * self.accel * left * left, self.accel * left, -self.accel)
            }
            Phase::Done => (self.length(), 0.0, 0.0),
        };
        Setpoint {
            position: self.start + self.direction * s,
            velocity: self.direction * v,
            acceleration: self.direction * a,
        }
    }

    fn length(&self) -> f32 {
        self.peak_velocity * (self.t_ramp + self.t_cruise)
    }

    /// Samples every `dt`, the last one being the end of the move.
    pub fn samples(&self, dt: f32) -> Samples<'_> {
        debug_assert!(dt > 0.0);
        Samples { profile: self, dt, next: Some(0) }
    }
}

/// Iterator made by [`Profile::samples`].
#[derive(Clone, Debug)]
pub struct Samples<'a> {
    profile: &'a Profile,
    dt: f32,
    next: Option<u32>,
}

impl Iterator for Samples<'_> {
    type Item = Setpoint;

    fn next(&mut self) -> Option<Setpoint> {
        let n = self.next?;
        let t = n as f32 * self.dt;
        self.next = (self.profile.phase(t) != Phase::Done).then_some(n + 1);
        Some(self.profile.at(t))
    }
}

/// Runs one move at a time; `step` is called from the control interrupt.
#[derive(Clone, Debug)]
pub struct Axis {
    v_max: f32,
    a_max: f32,
    position: f32,
    active: Option<(Profile, f32)>,
}

impl Axis {
    pub fn new(v_max: f32, a_max: f32) -> Self {
        Self { v_max, a_max, position: 0.0, active: None }
    }

    /// Starts a move; refused while another one runs.
    pub fn move_to(&mut self, target: f32) -> Result<f32, Setpoint> {
        if let Some((profile, t)) = &self.active {
            return Err(profile.at(*t));
        }
        let profile = Profile::plan(self.position, target, self.v_max, self.a_max)
            .ok_or(Setpoint { position: self.position, ..Default::default() })?;
        self.active = Some((profile, 0.0));
        Ok(profile.duration())
    }

    pub fn step(&mut self, dt: f32) -> Setpoint {
        let Some((profile, t)) = self.active.as_mut() else {
            return Setpoint { position: self.position, ..Setpoint::default() };
        };
        *t += dt;
        let setpoint = profile.at(*t);
        self.position = setpoint.position;
        if profile.phase(*t) == Phase::Done {
            self.active = None;
        }
        setpoint
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_move_has_a_cruise() {
        let p = Profile::plan(1.0, -9.0, 2.0, 4.0).unwrap();
        assert!((p.duration() - 5.5).abs() < 1e-5);
        assert_eq!(p.phase(1.0), Phase::Cruising);
        assert_eq!(p.at(1.0).velocity, -2.0);
        assert!((p.at(100.0).position + 9.0).abs() < 1e-5);
    }

    #[test]
    fn samples_end_at_the_target_and_never_exceed_limits() {
        let p = Profile::plan(0.0, 0.5, 2.0, 4.0).unwrap();
        assert!(p.samples(0.01).all(|s| s.velocity <= 1.5 && s.acceleration.abs() <= 4.0));
        let last = p.samples(0.01).last().unwrap();
        assert!((last.position - 0.5).abs() < 1e-5);
    }

    #[test]
    fn axis_refuses_overlapping_moves() {
        let mut axis = Axis::new(1.0, 1.0);
        assert!(axis.move_to(2.0).is_ok());
        axis.step(0.5);
        assert!(axis.move_to(0.0).is_err_and(|s| s.velocity > 0.4));
        (0..100).for_each(|_| {
            axis.step(0.1);
        });
        assert!(axis.move_to(0.0).is_ok());
    }
}
