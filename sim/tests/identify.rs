//! The identification on one simulated flight, and on any number of threads.

use sim::computer::Native;
use sim::identify::fit::fit;
use sim::identify::logged::Logged;
use sim::identify::segments::Segments;
use sim::identify::swarm::{Swarm, search};
use sim::identify::{replay, with_coefficients};
use sim::recording::{Log, mcap};
use sim::scenario::{Scenario, point};
use sim::voyage::fly;
use std::collections::BTreeMap;

const TRUTH: [f64; 4] = [0.0107 * 1.08, 0.0107 * 0.93, 0.0107 * 0.97, 0.0107 * 1.04];

fn logged() -> Logged {
    let points = [point(0.0, 0.0, 0.0, 1.0, 0.0)];
    let mut scenario = Scenario::mambo(&points, 16.0, models::Mode::ClosedLoop);
    scenario.airframe = with_coefficients(&scenario.airframe, &TRUTH);
    let voyage = fly(&scenario, &mut Native::default());
    let bytes = mcap(&voyage, &BTreeMap::new()).expect("it is written");
    Logged::of(&Log::of(&bytes, "test".into()).expect("it is read"), 0.015).expect("a flight")
}

fn on_threads<T: Send>(count: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().expect("a pool");
    pool.install(work)
}

#[test]
fn each_coefficient_is_found_whatever_the_number_of_threads() {
    let (logged, sheet) = (logged(), models::Airframe::mambo());
    let segments = Segments::of(&logged, &sheet);
    let found = |threads| {
        on_threads(threads, || fit(&segments, &[0.0107; 4], |_, _| ()).expect("a minimum"))
    };
    let one = found(1);
    for ((found, truth), confidence) in one.coefficients.iter().zip(TRUTH).zip(&one.confidence) {
        assert!((found / truth - 1.0).abs() < 0.01, "{found} for {truth}");
        assert!(*confidence < 0.01 * truth, "± {confidence}");
    }
    assert!(one.evaluations > 50, "{} costs", one.evaluations);
    assert_eq!(one, found(3));
}

#[test]
fn a_swarm_is_its_seed_whatever_the_number_of_threads() {
    let (logged, sheet) = (logged(), models::Airframe::mambo());
    let cost = |coefficients: &[f64]| replay::cost(&logged, &sheet, coefficients);
    let swarm = Swarm { particles: 10, iterations: 4, ..Swarm::thesis(4, 3) };
    let found = |threads| on_threads(threads, || search(&swarm, cost, |_, _| ()));
    let one = found(1);
    assert_eq!(one, found(3));
    assert_eq!(one.history.len(), 5);
    let falls = one.history.windows(2).all(|pair| pair[1] <= pair[0]);
    assert!(falls, "{:?}", one.history);
}

#[test]
fn the_replay_cost_punishes_a_crash() {
    let (logged, sheet) = (logged(), models::Airframe::mambo());
    let at = |factor: f64| replay::cost(&logged, &sheet, &TRUTH.map(|truth| factor * truth));
    assert!(at(0.5) > 30.0, "it falls at once: {}", at(0.5));
}
