//! Software and processor in the loop: the whole flight, every output and every state by bits.
//!
//! The plant flies with each leg in turn, closed loop; a single differing bit would part the flights.

mod emitted;
mod onboard;
mod text;
mod vectors;
mod zynq;

use std::thread;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_tests::pilot::{Wired, entry};
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::{compiled_with, flight_models, turn, words};
use models::Parameters;
use sim::{Flight, Mission, Native, Pilot, Vehicle, fly};

fn flown(pilot: &mut impl Pilot) -> Flight {
    fly(&Vehicle::mambo(), &Parameters::mambo(), &Mission::every_channel(), pilot)
}

/// The first step at which two flights part, and how.
fn parting(one: &Flight, other: &Flight) -> Option<String> {
    assert_eq!(one.steps.len(), 6000);
    assert_eq!(other.steps.len(), 6000);
    one.steps.iter().zip(&other.steps).enumerate().find_map(|(step, (one, other))| {
        let (outputs, others) = (words(&one.command), words(&other.command));
        let differs = !same(&outputs, &others) || !same(&one.memory, &other.memory);
        differs.then(|| {
            format!("step {step}: {outputs:x?} {:x?} / {others:x?} {:x?}", one.memory, other.memory)
        })
    })
}

/// Bits, save that any NaN is any NaN.
fn same(one: &[u64], other: &[u64]) -> bool {
    let equal = |(a, b): (&u64, &u64)| {
        a == b || (f64::from_bits(*a).is_nan() && f64::from_bits(*b).is_nan())
    };
    one.len() == other.len() && one.iter().zip(other).all(equal)
}

#[test]
fn the_interpreter_flies_the_same_bits() {
    let compiled = flight_models();
    let step = entry(compiled, "Controller", "step").expect("the controller has a step");
    let native = flown(&mut Native::new(Parameters::mambo()));
    let mut pilot = Wired::interpreted(compiled, step, &Parameters::mambo());
    assert_eq!(parting(&native, &flown(&mut pilot)), None);
}

fn fly_c(toolchains: &[Toolchain]) {
    flown_by(toolchains, flight_models());
}

fn flown_by(toolchains: &[Toolchain], compiled: &Compiled) {
    if toolchains.is_empty() {
        // Only where `BESSEMER_LEGS` does not demand them.
        println!("left out: the compilers are not installed");
        return;
    }
    let step = entry(compiled, "Controller", "step").expect("the controller has a step");
    let native = flown(&mut Native::new(Parameters::mambo()));
    thread::scope(|scope| {
        for toolchain in toolchains {
            let native = &native;
            scope.spawn(move || {
                let mut pilot = Wired::c(compiled, step, toolchain, &Parameters::mambo())
                    .unwrap_or_else(|error| panic!("{}: {error}", toolchain.name()));
                let parted = parting(native, &flown(&mut pilot));
                assert_eq!(parted, None, "{}", toolchain.name());
            });
        }
    });
    let names: Vec<String> = toolchains.iter().map(Toolchain::name).collect();
    println!("6000 steps bit-equal: {}", names.join(", "));
}

#[test]
fn the_c_flies_the_same_bits_on_this_machine() {
    fly_c(&turn::levels(toolchain::host()));
}

#[test]
fn the_c_flies_the_same_bits_on_the_cortex_a9() {
    fly_c(&turn::levels(toolchain::target()));
}

/// Checks processors with a fused multiply-add, which compilers would use.
#[test]
fn the_c_flies_the_same_bits_on_processors_that_fuse() {
    fly_c(&turn::some_of(toolchain::fusing(), 2));
}

/// Checks that were proved are in the C all the same, beside what C leaves undefined, and none of them fails.
#[test]
fn what_was_proved_holds_in_flight() {
    let kept = compiled_with("models", &Options { keep_checks: true, ..Options::default() });
    let more = &["-w", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"];
    let sanitized = Toolchain { level: 1, more, ..toolchain::GCC };
    let has_gcc = toolchain::host().iter().any(|it| it.compiler == sanitized.compiler);
    flown_by(has_gcc.then_some(sanitized).as_slice(), &kept);
}

/// In the full run.
#[test]
fn the_c_flies_the_same_bits_on_other_machines() {
    fly_c(&turn::others());
}
