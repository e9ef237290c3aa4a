//! Quadrotor mixer: thrust and torques to four motor commands, saturating with
//! priority on attitude, then thrust, yaw last.

use nalgebra::{Matrix4, Vector3, Vector4};

/// What the controllers want; thrust 0 to 1, torques about -1 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Demand {
    pub thrust: f32,
    pub roll: f32,
    pub pitch: f32,
    pub yaw: f32,
}

impl Demand {
    pub fn new(thrust: f32, torque: Vector3<f32>) -> Self {
        let [roll, pitch, yaw] = torque.into();
        Self { thrust, roll, pitch, yaw }
    }
}

impl From<Vector4<f32>> for Demand {
    fn from(v: Vector4<f32>) -> Self {
        let [thrust, roll, pitch, yaw] = v.into();
        Self { thrust, roll, pitch, yaw }
    }
}

/// Geometry of a frame, row per motor: thrust, roll, pitch, yaw.
pub trait Airframe {
    const MIX: [[f32; 4]; 4];

    fn matrix() -> Matrix4<f32> {
        Matrix4::from_fn(|r, c| Self::MIX[r][c])
    }
}

/// Motors front-right, rear-left, front-left, rear-right.
#[derive(Clone, Copy, Debug)]
pub struct QuadX;

impl Airframe for QuadX {
    #[rustfmt::skip]
    const MIX: [[f32; 4]; 4] = [
        [1.0, -0.5,  0.5,  0.25],
        [1.0,  0.5, -0.5,  0.25],
        [1.0,  0.5,  0.5, -0.25],
        [1.0, -0.5, -0.5, -0.25],
    ];
}

/// Motors right, left, front, rear.
#[derive(Clone, Copy, Debug)]
pub struct QuadPlus;

impl Airframe for QuadPlus {
    #[rustfmt::skip]
    const MIX: [[f32; 4]; 4] = [
        [1.0, -0.7,  0.0,  0.25],
        [1.0,  0.7,  0.0,  0.25],
        [1.0,  0.0,  0.7, -0.25],
        [1.0,  0.0, -0.7, -0.25],
    ];
}

/// Which demands could not be met in full.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Saturation {
    pub attitude: bool,
    pub thrust: bool,
    pub yaw: bool,
}

impl Saturation {
    pub fn any(self) -> bool {
        self.attitude || self.thrust || self.yaw
    }
}

#[derive(Clone, Debug)]
pub struct Mixer {
    mix: Matrix4<f32>,
    inverse: Matrix4<f32>,
    idle: f32,
    slew: f32,
    last: Vector4<f32>,
}

impl Mixer {
    /// `idle` is the least command of a running motor, `slew` the largest change
    /// per step.
    pub fn new<A: Airframe>(idle: f32, slew: f32) -> Option<Self> {
        let mix = A::matrix();
        let inverse = mix.try_inverse()?;
        (0.0..0.5).contains(&idle).then_some(Self { mix, inverse, idle, slew, last: Vector4::zeros() })
    }

    /// Mixes without regard to the slew limit.
    pub fn allocate(&self, demand: &Demand) -> (Vector4<f32>, Saturation) {
        let mut saturation = Saturation::default();
        let headroom = 1.0 - self.idle;
        let column = |c: usize| self.mix.column(c).into_owned();

        // Roll and pitch, scaled down together if they alone do not fit.
        let mut attitude = column(1) * demand.roll + column(2) * demand.pitch;
        let span = attitude.max() - attitude.min();
        if span > headroom {
            attitude *= headroom / span;
            saturation.attitude = true;
        }

        // Thrust moves to where the attitude fits.
        let (lowest, highest) = (self.idle - attitude.min(), 1.0 - attitude.max());
        let thrust = demand.thrust.max(lowest).min(highest.max(lowest));
        saturation.thrust = (thrust - demand.thrust).abs() > 1e-6;
        let base = column(0) * thrust + attitude;

        // Yaw takes what room is left.
        let yaw = column(3) * demand.yaw;
        let share = base
            .iter()
            .zip(yaw.iter())
            .map(|(&b, &y)| match y {
                y if y > 0.0 => (1.0 - b) / y,
                y if y < 0.0 => (self.idle - b) / y,
                _ => 1.0,
            })
            .fold(1.0_f32, f32::min)
            .max(0.0);
        saturation.yaw = share < 1.0;
        ((base + yaw * share).map(|m| m.clamp(self.idle, 1.0)), saturation)
    }

    /// One control period; `None` stops the motors.
    pub fn step(&mut self, demand: Option<&Demand>) -> [f32; 4] {
        let Some(demand) = demand else {
            self.last = Vector4::zeros();
            return [0.0; 4];
        };
        let (target, _) = self.allocate(demand);
        let change = (target - self.last).map(|d| d.clamp(-self.slew, self.slew));
        self.last += change;
        self.last.into()
    }

    /// The demand that the given commands amount to.
    pub fn achieved(&self, motors: &Vector4<f32>) -> Demand {
        (self.inverse * motors).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn in_range(m: &Vector4<f32>) -> bool {
        m.iter().all(|&v| (0.05..=1.0).contains(&v))
    }

    #[test]
    fn small_demands_are_met_exactly() {
        let mixers = [Mixer::new::<QuadX>(0.05, 1.0), Mixer::new::<QuadPlus>(0.05, 1.0)];
        for mixer in mixers.into_iter().flatten() {
            let demand = Demand::new(0.5, Vector3::new(0.1, -0.2, 0.3));
            let (motors, saturation) = mixer.allocate(&demand);
            let Demand { thrust, roll, pitch, yaw } = mixer.achieved(&motors);
            assert!(!saturation.any());
            assert!((thrust - 0.5).abs() < 1e-5 && (roll - 0.1).abs() < 1e-5);
            assert!((pitch + 0.2).abs() < 1e-5 && (yaw - 0.3).abs() < 1e-5);
        }
    }

    #[test]
    fn attitude_goes_before_thrust_and_yaw() {
        let mixer = Mixer::new::<QuadX>(0.05, 1.0).unwrap();
        let (motors, s) = mixer.allocate(&Demand { thrust: 1.0, roll: 0.4, pitch: 0.0, yaw: 1.0 });
        assert!(in_range(&motors) && s.thrust && s.yaw && !s.attitude);
        assert!((mixer.achieved(&motors).roll - 0.4).abs() < 1e-5);
        let (motors, s) = mixer.allocate(&Demand { thrust: 0.0, roll: 3.0, pitch: -2.0, yaw: 0.0 });
        assert!(in_range(&motors) && s.attitude, "{motors}");
        assert!(mixer.achieved(&motors).pitch < 0.0);
    }

    #[test]
    fn slew_and_stop() {
        let mut mixer = Mixer::new::<QuadPlus>(0.1, 0.05).unwrap();
        let hover = Demand { thrust: 0.5, ..Demand::default() };
        assert_eq!(mixer.step(Some(&hover)), [0.05; 4]);
        let end = (0..20).map(|_| mixer.step(Some(&hover))).last().unwrap();
        assert!(end.iter().all(|m| (m - 0.5).abs() < 1e-5));
        assert_eq!(mixer.step(None), [0.0; 4]);
    }
}
