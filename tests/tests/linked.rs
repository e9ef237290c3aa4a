//! A flight has the same bits where rustc compiles the flight software for another processor, or to WebAssembly. A project that
//! needs no C links that code. Only a full run does this.

use bessemer_tests::linked::{Flight, PROCESSORS, WASM, flown, flown_by_wasmtime, is_added};
use bessemer_tests::{root, turn};

/// Seconds of the flight: it takes off, and climbs.
const LONGEST: f64 = 10.0;

/// Returns true if rustup has added the target; the report names the missing one.
fn is_there(target: &str) -> bool {
    let there = is_added(target);
    if !there {
        println!("left out: `rustup target add {target}`");
    }
    there
}

#[test]
fn a_flight_has_the_same_bits_on_other_processors() {
    if !turn::is_full() {
        println!("left out: five builds of the models; BESSEMER_FULL=1 brings them in");
        return;
    }
    let flight = Flight::of("hover", LONGEST).expect("a flight");
    for (target, toolchain) in PROCESSORS {
        if is_there(target) {
            let results =
                flown(target, &toolchain, &flight).unwrap_or_else(|said| panic!("{said}"));
            assert!(flight.has(&results), "{target} has other bits");
        }
    }
    let python = root().join("target/python/bin/python");
    if is_there(WASM) {
        let results = flown_by_wasmtime(&python, &flight).unwrap_or_else(|said| panic!("{said}"));
        assert!(flight.has(&results), "WebAssembly has other bits");
    }
}
