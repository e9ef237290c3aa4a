//! The result of one flight, as the values of a row.
//!
//! The envelope refers to the true state, not to the software's estimate. The aircraft leaves it when its tilt,
//! speed, distance or touch-down speed exceeds a limit.

use super::dice;
use crate::batch::{self, Glimpse};
use crate::computer::Native;
use crate::plant::State;
use crate::scenario::Scenario;
use crate::voyage::follow;
use bessemer::math::ElementaryMethods;
use bessemer_campaign::{Column, Value, Worst};
use bessemer_lanes::sin_cos;
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
    outcome.broken(&scenario);
    scenario.settings.limits.armed = false;
    let free = watched(&scenario, Outcome::new(seed));
    outcome.left = free.left;
    outcome
}

/// Flies and observes, until the aircraft leaves the envelope.
fn watched(scenario: &Scenario, mut outcome: Outcome) -> Outcome {
    follow(scenario, &mut Native::default(), |moment, _| {
        outcome.look(&moment.into());
        outcome.left.is_infinite()
    });
    outcome
}

/// Flies scenarios at once, in vectors, and observes each as if it were alone.
fn watched_at_once(scenarios: &[Scenario], mut outcomes: Vec<Outcome>) -> Vec<Outcome> {
    batch::fly(scenarios, |flight, glimpse| {
        let Some(outcome) = outcomes.get_mut(flight) else { return false };
        outcome.look(glimpse);
        outcome.left.is_infinite()
    });
    outcomes
}

/// Flies the scenarios of several seeds at once, as [`of_spread`] each.
pub fn all_of_spread(seeds: &[u64]) -> Vec<Outcome> {
    let scenarios: Vec<Scenario> = seeds.iter().map(|seed| dice::scenario(*seed)).collect();
    watched_at_once(&scenarios, seeds.iter().map(|seed| Outcome::new(*seed)).collect())
}

/// Flies the scenarios of several seeds at once, as [`of_failure`] each.
pub fn all_of_failures(seeds: &[u64]) -> Vec<Outcome> {
    let mut scenarios: Vec<Scenario> = seeds.iter().map(|seed| dice::failing(*seed)).collect();
    let fresh = || seeds.iter().map(|seed| Outcome::new(*seed)).collect();
    let mut outcomes = watched_at_once(&scenarios, fresh());
    for (outcome, scenario) in outcomes.iter_mut().zip(&mut scenarios) {
        outcome.broken(scenario);
        scenario.settings.limits.armed = false;
    }
    let free = watched_at_once(&scenarios, fresh());
    outcomes.iter_mut().zip(free).for_each(|(outcome, free)| outcome.left = free.left);
    outcomes
}

/// Flies, and returns how far the aircraft came out of the envelope, as a share of its limits: 0 or more if it left it.
pub fn severity(scenario: &Scenario) -> f64 {
    let mut most = f64::NEG_INFINITY;
    follow(scenario, &mut Native::default(), |moment, _| {
        most = most.max(strain(&moment.into()));
        most <= 1.0
    });
    most - 1.0
}

/// Returns the largest of tilt, speed, distance and touch-down, each as a share of its limit: more than 1 outside the envelope.
/// Infinite if a figure of the state is no finite number.
fn strain(glimpse: &Glimpse) -> f64 {
    let state = &glimpse.state;
    if !state.is_finite() {
        return f64::INFINITY;
    }
    let upright = sin_cos(state.angles.x).1 * sin_cos(state.angles.y).1;
    let tilt = upright.dsl_acos();
    let shares = [
        tilt / TILT,
        state.velocity.norm() / SPEED,
        state.position.amax() / REACH,
        glimpse.impact / IMPACT,
    ];
    shares.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// Returns true if the [`strain`] is more than 1. Most aircraft are far within the limits, which costs less to see.
fn is_outside(glimpse: &Glimpse) -> bool {
    let State { position, velocity, angles, .. } = &glimpse.state;
    // Two angles of half a radian tilt by 0.7 rad at most.
    let steady = angles.x.abs() < 0.5 && angles.y.abs() < 0.5;
    let slow = velocity.amax() < SPEED / 2.0 && position.amax() < REACH;
    let calm = steady && slow && glimpse.impact < IMPACT && glimpse.state.is_finite();
    !calm && strain(glimpse) > 1.0
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

    /// Notes the failure of a scenario.
    fn broken(&mut self, scenario: &Scenario) {
        if let Some((at, failure)) = scenario.failure() {
            self.failure = format!("{failure:?}");
            self.broke = at;
        }
    }

    fn look(&mut self, glimpse: &Glimpse) {
        let Glimpse { time, state, alarm, .. } = glimpse;
        self.impact = self.impact.max(glimpse.impact);
        if self.left.is_infinite() && is_outside(glimpse) {
            self.left = *time;
        }
        if *alarm != Alarm::Clear && self.stopped.is_infinite() {
            self.stopped = *time;
            self.alarm = format!("{alarm:?}");
        }
        let settled = [(5.0, 8.0), (15.0, 18.0), (25.0, 28.0)];
        if settled.iter().any(|(from, to)| (*from..*to).contains(time)) {
            let error = glimpse.wanted - state.position;
            self.height = self.height.max(error.z.abs());
            self.place = self.place.max(error.xy().norm());
        }
        let over = glimpse.phase == Phase::Over && state.position.z <= 0.0;
        self.well = over && *alarm == Alarm::Clear && glimpse.motors == 0.0;
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
