//! The result of one flight, as the values of a row.
//!
//! The envelope refers to the true state, not to the software's estimate. The aircraft leaves it when its tilt,
//! speed, distance or touch-down speed exceeds a limit.

use super::dice;
use crate::computer::Native;
use crate::scenario::Scenario;
use crate::voyage::{Moment, follow};
use bessemer_campaign::{Column, Value, Worst};
use models::{Alarm, Phase};

/// Largest tilt, rad.
const TILT: f64 = 1.1;
/// Largest speed, m/s.
const SPEED: f64 = 4.3;
/// Largest height and distance, m.
const REACH: f64 = 4.5;
/// Fastest touch-down, m/s.
const IMPACT: f64 = 0.8;

/// Outcome of one flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Seed of the flight.
    pub seed: u64,
    /// Failure that was injected; `nothing` without one.
    pub failure: String,
    /// Time of the failure, s; infinite without one.
    pub broke: f64,
    /// Alarm that stopped the motors.
    pub alarm: String,
    /// Time of the stop, s; infinite without one.
    pub stopped: f64,
    /// Time when the aircraft left the envelope, s; infinite if it did not. With failures, it is that of a second
    /// flight, in which the crash predictor does not act.
    pub left: f64,
    /// Largest error of height from 5 s after each setpoint until the next, m.
    pub height: f64,
    /// Largest distance in the plane in the same times, m.
    pub place: f64,
    /// Hardest touch-down, m/s.
    pub impact: f64,
    /// True if it ended on the ground with the motors off and no alarm.
    pub well: bool,
}

/// Flies the scenario of a seed without a failure.
pub fn of_spread(seed: u64) -> Outcome {
    watched(&dice::scenario(seed), Outcome::new(seed))
}

/// Flies the scenario of a seed with a failure twice: with the crash predictor, and with one that does not act.
pub fn of_failure(seed: u64) -> Outcome {
    let mut scenario = dice::failing(seed);
    let mut outcome = watched(&scenario, Outcome::new(seed));
    if let Some((at, failure)) = scenario.failure() {
        outcome.failure = format!("{failure:?}");
        outcome.broke = at;
    }
    scenario.settings.limits.armed = false;
    let free = watched(&scenario, Outcome::new(seed));
    outcome.left = free.left;
    outcome
}

/// Flies and observes, until the aircraft leaves the envelope.
fn watched(scenario: &Scenario, mut outcome: Outcome) -> Outcome {
    follow(scenario, &mut Native::default(), |moment, _| {
        outcome.look(moment);
        outcome.left.is_infinite()
    });
    outcome
}

/// Flies, and returns how far the aircraft came out of the envelope, as a share of its limits: 0 or more if it left it.
pub fn severity(scenario: &Scenario) -> f64 {
    let mut most = f64::NEG_INFINITY;
    follow(scenario, &mut Native::default(), |moment, _| {
        most = most.max(strain(moment));
        most <= 1.0
    });
    most - 1.0
}

/// Returns the largest of tilt, speed, distance and touch-down, each as a share of its limit: more than 1 outside the envelope.
/// Infinite if a figure of the state is no finite number.
fn strain(moment: &Moment) -> f64 {
    let state = &moment.state;
    if !state.is_finite() {
        return f64::INFINITY;
    }
    let tilt = (state.angles.x.cos() * state.angles.y.cos()).acos();
    let shares = [
        tilt / TILT,
        state.velocity.norm() / SPEED,
        state.position.amax() / REACH,
        moment.impact / IMPACT,
    ];
    shares.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

impl Outcome {
    fn new(seed: u64) -> Self {
        Self {
            seed,
            failure: "nothing".into(),
            broke: f64::INFINITY,
            alarm: "none".into(),
            stopped: f64::INFINITY,
            left: f64::INFINITY,
            height: 0.0,
            place: 0.0,
            impact: 0.0,
            well: false,
        }
    }

    fn look(&mut self, moment: &Moment) {
        let (state, outputs) = (&moment.state, &moment.outputs);
        self.impact = self.impact.max(moment.impact);
        if strain(moment) > 1.0 && self.left.is_infinite() {
            self.left = moment.time;
        }
        if outputs.alarm != Alarm::Clear && self.stopped.is_infinite() {
            self.stopped = moment.time;
            self.alarm = format!("{:?}", outputs.alarm);
        }
        let settled = [(5.0, 8.0), (15.0, 18.0), (25.0, 28.0)];
        if settled.iter().any(|(from, to)| (*from..*to).contains(&moment.time)) {
            let error = outputs.reference.target.position - state.position;
            self.height = self.height.max(error.z.abs());
            self.place = self.place.max(error.xy().norm());
        }
        let over = outputs.reference.phase == Phase::Over && state.position.z <= 0.0;
        self.well = over && outputs.alarm == Alarm::Clear && outputs.command.motors.amax() == 0.0;
    }

    /// Returns true if the motors were stopped although the aircraft would have flown on for a second.
    pub fn stopped_for_nothing(&self) -> bool {
        self.stopped.is_finite() && self.left > self.stopped + 1.0
    }

    /// Returns true if the aircraft left the envelope before the motors were stopped.
    pub fn missed(&self) -> bool {
        self.left.is_finite() && self.stopped > self.left
    }
}

/// Returns the columns of a row.
pub fn columns() -> Vec<Column> {
    let time = |name, about| Column::number(name, "s").about(about).decimals(3).or_infinite();
    let size = |name, unit, about| {
        Column::number(name, unit).about(about).decimals(4).worst(Worst::Largest)
    };
    vec![
        Column::text("failure").about("failure that was injected"),
        time("broke", "time of the failure"),
        Column::text("alarm").about("alarm that stopped the motors"),
        time("stopped", "time of the stop"),
        time("left", "time when the aircraft left the envelope"),
        size("height", "m", "error of height once steady"),
        size("place", "m", "distance in the plane once steady"),
        size("impact", "m/s", "touch-down"),
        Column::truth("well").about("ended on the ground, motors off, without an alarm"),
    ]
}

impl Outcome {
    /// Returns the values of the row.
    pub fn values(self) -> Vec<Value> {
        vec![
            self.failure.into(),
            self.broke.into(),
            self.alarm.into(),
            self.stopped.into(),
            self.left.into(),
            self.height.into(),
            self.place.into(),
            self.impact.into(),
            self.well.into(),
        ]
    }

    /// Returns the result that a row has; `None` if the row has no such values.
    pub fn of(seed: u64, values: &[Value]) -> Option<Self> {
        use Value::{Number, Text, Truth};
        let [
            Text(failure),
            Number(broke),
            Text(alarm),
            Number(stopped),
            Number(left),
            Number(height),
            Number(place),
            Number(impact),
            Truth(well),
        ] = values
        else {
            return None;
        };
        let (failure, alarm) = (failure.clone(), alarm.clone());
        let (broke, stopped, left) = (*broke, *stopped, *left);
        let (height, place, impact, well) = (*height, *place, *impact, *well);
        Some(Self { seed, failure, broke, alarm, stopped, left, height, place, impact, well })
    }
}
