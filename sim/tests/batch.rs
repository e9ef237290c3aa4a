//! Flights at once, in vectors: each has the bits of the flight alone.

use sim::batch::{self, Glimpse};
use sim::campaign::{Kind, dice, outcome};
use sim::computer::Native;
use sim::scenario::Scenario;
use sim::{Aircraft, voyage};

/// Returns every glimpse of a flight alone.
fn alone(scenario: &Scenario) -> Vec<Glimpse> {
    let mut seen = Vec::new();
    voyage::follow(scenario, &mut Native::default(), |moment, _| {
        seen.push(moment.into());
        true
    });
    seen
}

fn at_once(scenarios: &[Scenario]) -> Vec<Vec<Glimpse>> {
    let mut seen = vec![Vec::new(); scenarios.len()];
    batch::fly(scenarios, |flight, glimpse| {
        seen[flight].push(*glimpse);
        true
    });
    seen
}

/// Each bit of a glimpse: `{:?}` of a number has them all, and any NaN is any NaN.
fn same(one: &[Glimpse], other: &[Glimpse]) {
    assert_eq!(one.len(), other.len());
    for (one, other) in one.iter().zip(other) {
        assert_eq!(format!("{one:?}"), format!("{other:?}"));
    }
}

#[test]
fn every_period_of_flights_at_once_equals_the_flight_alone() {
    // Gains, motors and sensors that fail, and one flight without a failure; each has a length of its own.
    let mut scenarios: Vec<Scenario> =
        [1, 2, 3, 6].map(|seed| Kind::Failures.scenario(seed)).into();
    scenarios.push(dice::scenario(4));
    for (n, scenario) in scenarios.iter_mut().enumerate() {
        scenario.duration = 3.0 + n as f64 / 2.0;
        if let Some((_, failure)) = scenario.failure() {
            scenario.fail(1.5, failure);
        }
    }
    for (scenario, seen) in scenarios.iter().zip(at_once(&scenarios)) {
        same(&alone(scenario), &seen);
    }
}

#[test]
fn flights_that_differ_in_form_are_flown_one_by_one() {
    let mut scenarios = vec![dice::scenario(1), dice::scenario(2)];
    scenarios[1].airframe = Aircraft::F550.airframe();
    scenarios[1].settings = Aircraft::F550.settings();
    scenarios.iter_mut().for_each(|it| it.duration = 0.5);
    for (scenario, seen) in scenarios.iter().zip(at_once(&scenarios)) {
        same(&alone(scenario), &seen);
    }
}

#[test]
fn a_flight_ends_when_it_was_seen_enough() {
    let scenarios: Vec<Scenario> = (0..9).map(dice::scenario).collect();
    let mut seen = [0; 9];
    batch::fly(&scenarios, |flight, _| {
        seen[flight] += 1;
        seen[flight] < 10 * (flight + 1)
    });
    assert_eq!(seen, std::array::from_fn(|flight| 10 * (flight + 1)));
}

#[test]
fn outcomes_at_once_are_those_of_each_seed() {
    let seeds = [3, 5];
    assert_eq!(outcome::all_of_spread(&seeds), seeds.map(outcome::of_spread));
    assert_eq!(outcome::all_of_failures(&seeds), seeds.map(outcome::of_failure));
}
