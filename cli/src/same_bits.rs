//! `verify` for a `#[test]` of the user's package: the inputs are the test's own.

use std::path::Path;

use bessemer::Plain;

use crate::args::Verify;
use crate::verify;

/// Holds an entry point of the component `C` to the same bits as Rust, in the interpreter and as C by each compiler that is there.
///
/// `entry` is the method; an input is a tuple of its arguments behind `self`, in their order, what is borrowed by value.
/// The component begins in its initial state and lives from input to input. It is called from a test of the package of the
/// models, which has `cargo-bessemer` among its `[dev-dependencies]`:
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
/// If a word differs, with the table of `cargo bessemer verify`; if something is missing, with what to do about it.
#[track_caller]
pub fn same_bits<C, I: Plain>(entry: &str, inputs: impl IntoIterator<Item = I>) {
    // cargo says where the package is to whatever it runs.
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| ".".into());
    same_bits_at::<C, I>(Path::new(&folder), entry, inputs);
}

/// The same of the package in this folder.
///
/// # Panics
/// As [`same_bits`] does.
#[track_caller]
pub fn same_bits_at<C, I: Plain>(folder: &Path, entry: &str, inputs: impl IntoIterator<Item = I>) {
    let path = std::any::type_name::<C>();
    let component = path.split('<').next().and_then(|path| path.rsplit("::").next());
    let entry = Some(format!("{}::{entry}", component.unwrap_or(path)));
    let calls: Vec<Vec<u64>> =
        inputs.into_iter().map(|input| bessemer_legs::words(&input)).collect();
    let wanted = Verify { entry, ..Verify::default() };
    match verify::with_words(folder, &wanted, &calls) {
        Ok((_, true)) => {}
        Ok((text, false)) => panic!("{text}"),
        Err(error) => {
            let remedy = error.remedy().map(|remedy| format!("; {remedy}")).unwrap_or_default();
            panic!("{error}{remedy}")
        }
    }
}
