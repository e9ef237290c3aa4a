//! PID with anti-windup by back-calculation, derivative on the measurement, and bumpless transfer from manual
//! (Åström and Murray, Feedback Systems, ch. 11).

use bessemer::prelude::*;

/// Gains and limits of a controller.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tuning {
    pub p: f64,
    pub i: f64,
    pub d: f64,
    /// Time constant of the filter of the derivative, s.
    pub filter: f64,
    /// Rate at which the integral follows a limited output, 1/s.
    pub tracking: f64,
    pub low: f64,
    pub high: f64,
}

/// State of the controller.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Regulator {
    integral: f64,
    derivative: f64,
    before: f64,
    running: bool,
}

#[component]
impl Regulator {
    /// One period of `time` s in automatic mode; returns the output within its limits.
    #[entry]
    pub fn step(&mut self, tuning: &Tuning, target: f64, measured: f64, time: f64) -> f64 {
        assert!(time > 0.0);
        let error = target - measured;
        if !self.running {
            self.before = measured;
            self.running = true;
        }
        let share = tuning.filter / (tuning.filter + time);
        let slope = (measured - self.before) / time;
        self.derivative = share * self.derivative + (1.0 - share) * slope;
        self.before = measured;
        let wanted = tuning.p * error + self.integral - tuning.d * self.derivative;
        let output = wanted.clamp(tuning.low, tuning.high);
        self.integral += time * (tuning.i * error + tuning.tracking * (output - wanted));
        output
    }

    /// One period in manual mode: sets the integral so that the next automatic step starts from `output`.
    #[entry(infallible)]
    pub fn follow(&mut self, tuning: &Tuning, target: f64, measured: f64, output: f64) {
        self.integral = output - tuning.p * (target - measured);
        self.derivative = 0.0;
        self.before = measured;
        self.running = true;
    }
}
