//! `verify` for a `#[test]` of the user's package, with inputs of the test.

use std::path::Path;

use bessemer::Plain;
use bessemer_words::record::{self, Calls};

use crate::args::Verify;
use crate::verify;

/// Compares an entry point of the component `C` in Rust with the interpreter and with its C from each compiler on this machine.
///
/// `entry` is the name of the method. An input is a tuple of its arguments behind `self`, in their order; a borrowed argument
/// is in it by value. The component begins in its initial state and keeps its state from input to input. Call this from
/// a test of the package with the models, which has `cargo-bessemer` among its `[dev-dependencies]`:
///
/// ```no_run
/// # #[derive(Default)]
/// # struct Motor;
/// # let gains = 0.0;
/// // Motor::step(&mut self, gains: &Gains, target: f64, speed: f64)
/// cargo_bessemer::same_bits::<Motor, _>("step", (0..100).map(|n| (gains, 100.0, f64::from(n))));
/// ```
///
/// # Panics
/// It panics if a word differs, with the table of `cargo bessemer verify`, and on any error, with its remedy.
#[track_caller]
pub fn same_bits<C, I: Plain>(entry: &str, inputs: impl IntoIterator<Item = I>) {
    // cargo sets this for each test that it runs.
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| ".".into());
    same_bits_at::<C, I>(Path::new(&folder), entry, inputs);
}

/// Writes the calls of a test, if a dossier requests them.
fn keep(calls: &Calls) {
    if let Some(folder) = std::env::var_os(record::FOLDER)
        && let Err(error) = calls.write(Path::new(&folder))
    {
        anstream::eprintln!("the calls of {} are missing in the coverage: {error}", calls.entry);
    }
}

/// Compares the legs for the package in this folder.
///
/// # Panics
/// As [`same_bits`] does.
#[track_caller]
pub fn same_bits_at<C, I: Plain>(folder: &Path, entry: &str, inputs: impl IntoIterator<Item = I>) {
    let entry = format!("{}::{entry}", record::component::<C>());
    let calls: Vec<Vec<u64>> =
        inputs.into_iter().map(|input| bessemer_legs::words(&input)).collect();
    let calls = Calls { entry, calls };
    keep(&calls);
    let wanted = Verify { entry: Some(calls.entry), ..Verify::default() };
    let calls = calls.calls;
    match verify::with_words(folder, &wanted, &calls) {
        Ok((_, true)) => {}
        Ok((text, false)) => panic!("{text}"),
        Err(error) => {
            let remedy = error.remedy().map(|remedy| format!("; {remedy}")).unwrap_or_default();
            panic!("{error}{remedy}")
        }
    }
}
