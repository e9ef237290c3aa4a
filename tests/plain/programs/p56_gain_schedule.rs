//! PID controller whose gains are looked up in a two-dimensional table.

use core::ops::{Add, Mul};

/// Anything that can be blended linearly.
pub trait Lerp: Copy {
    fn lerp(self, other: Self, t: f32) -> Self;
}

impl<T> Lerp for T
where
    T: Copy + Add<Output = T> + Mul<f32, Output = T>,
{
    fn lerp(self, other: Self, t: f32) -> Self {
        self * (1.0 - t) + other * t
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gains {
    pub kp: f32,
    pub ki: f32,
    pub kd: f32,
}

impl Add for Gains {
    type Output = Self;

    fn add(self, rhs: Self) -> Self {
        Self { kp: self.kp + rhs.kp, ki: self.ki + rhs.ki, kd: self.kd + rhs.kd }
    }
}

impl Mul<f32> for Gains {
    type Output = Self;

    fn mul(self, factor: f32) -> Self {
        Self { kp: self.kp * factor, ki: self.ki * factor, kd: self.kd * factor }
    }
}

/// Strictly rising breakpoints of one table axis.
#[derive(Debug, Clone, Copy)]
pub struct Axis<const N: usize>([f32; N]);

impl<const N: usize> Axis<N> {
    /// Returns `None` unless there are at least two rising breakpoints.
    pub fn new(points: [f32; N]) -> Option<Self> {
        let rising = points.windows(2).all(|w| w[0] < w[1]);
        (N >= 2 && rising).then_some(Self(points))
    }

    /// Index of the cell that holds `x` and the position within it, clamped
    /// to the ends of the axis.
    fn locate(&self, x: f32) -> (usize, f32) {
        let cell = self.0[1..N - 1].partition_point(|&p| p <= x);
        let (low, high) = (self.0[cell], self.0[cell + 1]);
        (cell, ((x - low) / (high - low)).clamp(0.0, 1.0))
    }
}

/// Bilinear lookup table.
#[derive(Debug, Clone, Copy)]
pub struct Table2d<T, const R: usize, const C: usize> {
    pub rows: Axis<R>,
    pub columns: Axis<C>,
    pub values: [[T; C]; R],
}

impl<T: Lerp, const R: usize, const C: usize> Table2d<T, R, C> {
    pub fn lookup(&self, row: f32, column: f32) -> T {
        let (i, u) = self.rows.locate(row);
        let (j, v) = self.columns.locate(column);
        let along_row = |r: usize| self.values[r][j].lerp(self.values[r][j + 1], v);
        along_row(i).lerp(along_row(i + 1), u)
    }
}

#[derive(Debug, Clone, Copy)]
pub struct Limits {
    pub min: f32,
    pub max: f32,
}

/// PID with derivative on measurement and conditional integration. The
/// integral keeps the already scaled term so that a gain change is bumpless.
#[derive(Debug, Clone)]
pub struct ScheduledPid<const R: usize, const C: usize> {
    table: Table2d<Gains, R, C>,
    limits: Limits,
    integral: f32,
    last_measurement: Option<f32>,
}

impl<const R: usize, const C: usize> ScheduledPid<R, C> {
    pub fn new(table: Table2d<Gains, R, C>, limits: Limits) -> Self {
        Self { table, limits, integral: 0.0, last_measurement: None }
    }

    pub fn reset(&mut self) {
        self.integral = 0.0;
        self.last_measurement = None;
    }

    /// `operating_point` holds the row and column scheduling variables.
    pub fn update(
        &mut self,
        setpoint: f32,
        measurement: f32,
        operating_point: (f32, f32),
        dt: f32,
    ) -> f32 {
        let Gains { kp, ki, kd } = self.table.lookup(operating_point.0, operating_point.1);
        let error = setpoint - measurement;
        let slope = self
            .last_measurement
            .replace(measurement)
            .map_or(0.0, |last| (measurement - last) / dt);

        let integral = self.integral + ki * error * dt;
        let raw = kp * error + integral - kd * slope;
        let output = raw.clamp(self.limits.min, self.limits.max);

        let winds_up = (raw - output) * error > 0.0;
        if !winds_up {
            self.integral = integral;
        }
        output
    }
}
