//! The complete onboard software in the loop. Every flight runs with its C, and every output and state is compared by
//! bits. The model of the plant is C too, driven by the motors of every flight.

use std::sync::Mutex;

use bessemer_ir::FunctionId;
use bessemer_tests::process::Process;
use bessemer_tests::store::once;
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::{alive, entry, flight_models, texts, turn, words};
use models::plant::Plant;
use sim::computer::{Computer, Native};
use sim::flights::{FLIGHTS, Flight, find};
use sim::scenario::Scenario;
use sim::voyage::{fly, follow};
use sim_program::emitted::Emitted;

/// Simulated part of a flight, s: the longest takes three minutes, and `cargo xtask sim all --c` flies it whole.
const LONGEST: f64 = 75.0;

/// A run that is not full flies one flight of so many, others at each turn.
const SHARED: usize = 5;

/// Bits, save that any NaN is any NaN.
fn plain(words: &[u64]) -> impl Iterator<Item = u64> + '_ {
    words.iter().map(|word| if f64::from_bits(*word).is_nan() { u64::MAX } else { *word })
}

/// A digest of outputs and state of each period.
fn flown<C: Computer>(scenario: &Scenario, computer: &mut C) -> Vec<u64> {
    let mut sums = Vec::new();
    follow(scenario, computer, |_, computer| {
        sums.push(computer.digest());
        true
    });
    sums
}

fn same(flight: &Flight, longest: f64, toolchain: &Toolchain, computer: &mut Emitted) {
    let mut scenario = (flight.scenario)(1);
    scenario.duration = scenario.duration.min(longest);
    computer.restart(toolchain).unwrap_or_else(|error| panic!("{error}"));
    let (native, other) = (flown(&scenario, &mut Native::default()), flown(&scenario, computer));
    assert!(native.len() > 1000);
    let parted = native.iter().zip(&other).position(|(here, there)| here != there);
    assert_eq!(parted, None, "{} with {}", flight.name, toolchain.name());
}

fn started(toolchain: &Toolchain) -> Emitted {
    Emitted::start(flight_models(), toolchain)
        .unwrap_or_else(|error| panic!("{}: {error}", toolchain.name()))
}

#[test]
fn the_c_flies_every_flight_to_the_same_bits() {
    let Some(toolchain) = turn::levels(toolchain::host()).into_iter().next() else {
        println!("left out: the compilers are not installed");
        return;
    };
    let content = (texts(&flight_models().files), &toolchain);
    once("every flight", &content, || fly_in_c(&toolchain));
}

fn fly_in_c(toolchain: &Toolchain) {
    let flights = turn::some_of(FLIGHTS.iter().collect(), FLIGHTS.len().div_ceil(SHARED));
    let left = Mutex::new(flights.into_iter());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                let mut computer = started(toolchain);
                loop {
                    let next = left.lock().expect("no thread panicked").next();
                    let Some(flight) = next else { break };
                    same(flight, LONGEST, toolchain, &mut computer);
                }
            });
        }
    });
}

#[test]
fn every_compiler_flies_a_hover_to_the_same_bits() {
    let hover = find("hover").expect("a flight");
    let fusing = turn::one_of(toolchain::fusing());
    for toolchain in turn::levels(toolchain::all()).into_iter().chain(fusing).chain(turn::others())
    {
        once("a hover", &(texts(&flight_models().files), &toolchain), || {
            same(hover, 6.0, &toolchain, &mut started(&toolchain));
        });
    }
}

#[test]
fn the_plant_model_moves_to_the_same_bits_in_every_flight() {
    let step = entry(flight_models(), "Plant", "step").expect("an entry point");
    once("the plant", &texts(&flight_models().files), || move_the_plant(step));
}

fn move_the_plant(step: FunctionId) {
    let toolchains = turn::levels(toolchain::all());
    let mut processes: Vec<_> = toolchains
        .iter()
        .map(|toolchain| {
            Process::start(flight_models(), step, toolchain)
                .unwrap_or_else(|error| panic!("{}: {error}", toolchain.name()))
        })
        .collect();
    for flight in turn::some_of(FLIGHTS.iter().collect(), FLIGHTS.len().div_ceil(SHARED)) {
        let mut scenario = (flight.scenario)(1);
        scenario.duration = scenario.duration.min(15.0);
        let period = scenario.settings.parameters.period;
        let (mut plant, mut arguments, mut expected) = (Plant::default(), Vec::new(), Vec::new());
        for moment in fly(&scenario, &mut Native::default()).moments {
            let motion = plant.step(&scenario.airframe, &moment.speeds, period);
            let given = [words(&scenario.airframe), words(&moment.speeds), words(&period)];
            arguments.push(given.concat());
            expected.push([vec![0], words(&motion), words(&plant)].concat());
        }
        for (process, toolchain) in processes.iter_mut().zip(&toolchains) {
            process.restart(toolchain).unwrap_or_else(|error| panic!("{error}"));
            for (arguments, expected) in arguments.iter().zip(&expected) {
                let results = process
                    .step(arguments)
                    .unwrap_or_else(|error| panic!("{}: {error}", flight.name));
                assert!(
                    plain(&results).eq(plain(expected)),
                    "{} with {}",
                    flight.name,
                    toolchain.name()
                );
            }
        }
    }
}

#[test]
fn work_is_little_more_than_what_is_alive_at_once() {
    let lent = alive::lent(flight_models());
    assert!(lent.iter().any(|(name, bytes, _)| name.ends_with("onboard::step") && *bytes < 2700));
    for (name, bytes, alive) in lent {
        assert!(10 * bytes <= 11 * alive, "{name} is lent {bytes} bytes, and needs {alive}");
    }
}
