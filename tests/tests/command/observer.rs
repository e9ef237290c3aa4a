//! An observer whose state, parameters and arguments are arrays of several kinds. It is compiled twice: here, where it is the
//! simulation, and as a file of the package under test, whose C is described to other tools and called from Python.

use bessemer::prelude::*;

/// Mode of the observer.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mode {
    /// Not at all.
    #[default]
    Off,
    /// As it is "tuned".
    Tuned,
}

/// Tuning of the observer. With short enums `period` has another offset, but the size is equal. With short enums
/// `period` lies elsewhere, though all of it is as large.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// Slopes of the axes.
    #[unit("N·m/A")]
    #[range(-1.5..=2.5)]
    pub slopes: [f32; 3],
    /// Inertia of both bodies.
    pub inertia: SMatrix<f64, 2, 3>,
    /// Anything.
    pub offset: i64,
    /// Mode of the observer.
    pub mode: Mode,
    /// Between "two" steps.
    #[unit("µs")]
    #[range(1..=5000)]
    pub period: u16,
    /// Maps of the "engine".
    pub maps: Maps,
}

/// Points of an axis.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Points {
    /// In ascending order.
    #[range(0..=100)]
    pub points: [u16; 2],
}

/// Tables and their axes.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Maps {
    /// Speeds.
    #[unit("1/min")]
    pub speeds: [f32; 3],
    /// Loads.
    pub loads: Points,
    /// Full load by speed.
    #[axes(speeds)]
    #[unit("N·m")]
    #[range(0.0..=400.0)]
    pub full: [f64; 3],
    /// Ignition by speed and load.
    #[axes(speeds, loads)]
    pub ignition: [[i8; 2]; 3],
}

impl Default for Tuning {
    fn default() -> Self {
        Tuning {
            slopes: [0.1, -0.2, 2.5],
            mode: Mode::Tuned,
            period: 5000,
            inertia: SMatrix::<f64, 2, 3>::new(0.1, 0.2, 0.3, 0.4, 0.5, 0.6),
            offset: -3,
            maps: Maps {
                speeds: [800.0, 2000.0, 6000.0],
                loads: Points { points: [10, 100] },
                full: [90.0, 120.0, 80.0],
                ignition: [[5, 4], [8, 7], [9, 10]],
            },
        }
    }
}

/// State of the observer.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observer {
    /// Mode of the last step.
    pub mode: Mode,
    /// Sign of the last weight.
    pub sign: i8,
    /// Position.
    #[unit("m")]
    pub place: Vector3<f64>,
    /// Learnt gains.
    pub gains: SMatrix<f64, 3, 2>,
    /// Number of calls.
    pub calls: u8,
    /// Last two tunings.
    pub told: [Tuning; 2],
}

#[component]
impl Observer {
    /// One step; the 256th is one too many.
    #[entry]
    pub fn step(
        &mut self,
        tuning: &Tuning,
        measured: &SMatrix<f64, 2, 3>,
        drift: &mut Vector3<f64>,
        weights: &[f32; 3],
        least: u16,
    ) -> SMatrix<f64, 3, 2> {
        self.calls += 1;
        self.mode = tuning.mode;
        self.sign = if weights[1] < tuning.slopes[0] { -1 } else { 1 };
        self.gains = self.gains * 0.5 + (measured + tuning.inertia).transpose();
        let weights =
            Vector3::new(f64::from(weights[0]), f64::from(weights[1]), f64::from(weights[2]));
        let moved = self.gains * Vector2::new(weights.x, weights.y);
        let period = f64::from(tuning.period.max(least)) * 1e-6;
        self.place += moved * period + *drift;
        *drift = self.place * weights.z;
        self.told = [*tuning, self.told[0]];
        self.gains
    }
    /// Sums of two large tables, which are never in use at one time.
    #[entry(infallible)]
    pub fn spread(&mut self, at: u8) -> f64 {
        let mut wide = [0.25; 40];
        wide[usize::from(at % 40)] = self.place.x;
        let sum: f64 = wide.iter().sum();
        let mut long = [0.5_f32; 80];
        long[usize::from(at % 80)] = self.place.y as f32;
        sum + f64::from(long.iter().sum::<f32>())
    }
}
