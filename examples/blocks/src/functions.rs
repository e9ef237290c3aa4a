//! The blocks that are functions, or methods of plain data, as entry points.

use bessemer::prelude::*;
use bessemer_blocks as blocks;
use blocks::{Axis, Beyond, Hysteresis, Search, UniformAxis};

/// Roots of unity for 64 points.
#[data]
pub static ROOTS: [[f32; 2]; 32] = blocks::roots_f32();

/// Functions, each an entry point.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Functions {
    hysteresis: Hysteresis,
    search: Search,
    debounce: blocks::Debounce,
    timer: blocks::Timer,
    watchdog: blocks::Watchdog,
}

#[component]
impl Functions {
    /// Designs a notch.
    #[entry(infallible, single)]
    pub fn section(&self, frequency: f32) -> blocks::Section<f32> {
        blocks::Section::notch(frequency, 5.0, 1000.0)
    }

    /// Saturates.
    #[entry(infallible, single)]
    pub fn saturated(&self, value: f32, low: f32, high: f32) -> blocks::Saturated<f32> {
        blocks::saturated(value, low, high)
    }

    /// Applies a dead band.
    #[entry(infallible, single)]
    pub fn dead_band(&self, value: f32, width: f32) -> f32 {
        blocks::dead_band(value, width)
    }

    /// Switches with hysteresis.
    #[entry(infallible, single)]
    pub fn hysteresis(&mut self, value: f32) -> bool {
        self.hysteresis.step(1.0, -1.0, value)
    }

    /// Debounces.
    #[entry(infallible, single)]
    pub fn debounce(&mut self, contact: bool) -> blocks::Contact {
        self.debounce.step(3, contact)
    }

    /// Waits.
    #[entry(infallible, single)]
    pub fn timer(&mut self, waiting: bool) -> bool {
        self.timer.step(100, waiting)
    }

    /// Watches.
    #[entry(infallible, single)]
    pub fn watchdog(&mut self, alive: bool) -> bool {
        self.watchdog.step(5, alive)
    }

    /// Returns a median.
    #[entry(infallible, single)]
    pub fn median(&self, values: [f32; 3]) -> f32 {
        let [a, b, c] = values;
        blocks::median(a, b, c)
    }

    /// Interpolates in a table of 16 points at equal distances.
    #[entry(infallible, single)]
    pub fn uniform_axis(&self, axis: &UniformAxis<f32, 16>, values: &[f32; 16], at: f32) -> f32 {
        blocks::interpolated(values, axis.place(at, Beyond::Hold))
    }

    /// Interpolates in a table of 16 points.
    #[entry(infallible, single)]
    pub fn axis(&self, axis: &Axis<f32, 16>, values: &[f32; 16], at: f32) -> f32 {
        blocks::interpolated(values, axis.place(at, Beyond::Hold))
    }

    /// Interpolates in a table of 16 points, with memory.
    #[entry(infallible, single)]
    pub fn search(&mut self, axis: &Axis<f32, 16>, values: &[f32; 16], at: f32) -> f32 {
        blocks::interpolated(values, self.search.place(axis, at, Beyond::Hold))
    }

    /// Interpolates in a table of 8 by 8 points at equal distances.
    #[entry(infallible, single)]
    pub fn interpolated_2d(
        &self,
        axis: &UniformAxis<f32, 8>,
        values: &[[f32; 8]; 8],
        at: [f32; 2],
    ) -> f32 {
        let [row, column] = at;
        let (row, column) = (axis.place(row, Beyond::Hold), axis.place(column, Beyond::Hold));
        blocks::interpolated_2d(values, row, column)
    }

    /// Evaluates three segments.
    #[entry(infallible, single)]
    pub fn trapezoid(&self, motion: &blocks::Trapezoid<f32>, time: f32) -> blocks::Point<f32> {
        motion.at(time)
    }

    /// Evaluates an S-curve.
    #[entry(infallible, single)]
    pub fn s_curve(&self, motion: &blocks::SCurve<f32>, time: f32) -> blocks::Point<f32> {
        motion.at(time)
    }

    /// Evaluates a motion with minimum jerk.
    #[entry(infallible, single)]
    pub fn minimum_jerk(&self, motion: &blocks::MinimumJerk<f32>, time: f32) -> blocks::Point<f32> {
        motion.at(time)
    }

    /// Evaluates a motion with minimum snap.
    #[entry(infallible, single)]
    pub fn minimum_snap(&self, motion: &blocks::MinimumSnap<f32>, time: f32) -> blocks::Point<f32> {
        motion.at(time)
    }

    /// Transforms two currents to the stator's frame.
    #[entry(infallible, single)]
    pub fn clarke(&self, a: f32, b: f32) -> blocks::Stator<f32> {
        blocks::clarke(a, b)
    }

    /// Transforms to the rotor's frame.
    #[entry(infallible, single)]
    pub fn park(&self, vector: &blocks::Stator<f32>, sine: f32, cosine: f32) -> blocks::Rotor<f32> {
        blocks::park(*vector, sine, cosine)
    }

    /// Modulates.
    #[entry(infallible, single)]
    pub fn space_vector(&self, voltage: &blocks::Stator<f32>, supply: f32) -> blocks::Duties<f32> {
        blocks::space_vector(*voltage, supply)
    }

    /// Splits a current.
    #[entry(infallible, single)]
    pub fn mtpa(&self, current: f32) -> blocks::Rotor<f32> {
        blocks::mtpa(current, 0.01, 1e-3, 2e-3)
    }

    /// Controls an attitude.
    #[entry(infallible, single)]
    pub fn attitude_torque(
        &self,
        gains: &blocks::AttitudeGains<f32>,
        attitude: &UnitQuaternion<f32>,
        rates: &Vector3<f32>,
        target: &UnitQuaternion<f32>,
    ) -> Vector3<f32> {
        blocks::attitude_torque(gains, attitude, rates, target, &Vector3::zeros())
    }

    /// Sums 64 bytes.
    #[entry(infallible)]
    pub fn crc32(&self, bytes: &[u8; 64]) -> u32 {
        blocks::crc32(&blocks::CRC32_IEEE, 0, bytes)
    }

    /// Reads a CAN signal.
    #[entry(infallible)]
    pub fn read_signal(&self, frame: &[u8; 8]) -> f32 {
        let signal = blocks::Signal { start: 12, bits: 12, scale: 0.5, ..Default::default() };
        blocks::read_signal(frame, &signal)
    }

    /// Transforms 64 points.
    #[entry(infallible)]
    pub fn fft(&self, re: &mut [f32; 64], im: &mut [f32; 64]) {
        blocks::fft(re, im, &ROOTS);
    }

    /// Measures one tone in 64 samples.
    #[entry(infallible, single)]
    pub fn goertzel(&self, samples: &[f32; 64], cycles: f32) -> f32 {
        blocks::goertzel(samples, cycles)
    }
}

/// `RealTimeIteration` of a pendulum on a cart: 4 states, 1 input and 1 output with limits over 8 periods, for 12 changes.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RealTimeIterationCost {
    plan: blocks::RealTimeIteration<f32, 4, 1, 1, 8, 8, 16, 12>,
}

#[component]
impl RealTimeIterationCost {
    /// Plans.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        horizon: &blocks::Horizon<f32, 4, 1, 1>,
        state: &Vector4<f32>,
        targets: &[Vector4<f32>; 8],
    ) -> blocks::Receding<f32, 1> {
        self.plan.step(horizon, state, targets, |state, push| {
            let (sine, cosine) = state[1].sin_cos();
            let rate = state[3] + 0.1 * (19.62 * sine - 2.0 * push[0] * cosine);
            let speed = state[2] + 0.1 * push[0];
            let slope = 0.1 * (19.62 * cosine + 2.0 * push[0] * sine);
            let next = Vector4::new(state[0] + 0.1 * speed, state[1] + 0.1 * rate, speed, rate);
            let mut by_state = Matrix4::identity();
            by_state[(0, 2)] = 0.1;
            by_state[(1, 1)] = 1.0 + 0.1 * slope;
            by_state[(1, 3)] = 0.1;
            by_state[(3, 1)] = slope;
            let turned = -0.2 * cosine;
            (next, by_state, Vector4::new(0.01, 0.1 * turned, 0.1, turned))
        })
    }
}
