//! `verify` for a `#[test]` of the user's package, with inputs of the test.

use std::path::Path;

use bessemer::Plain;

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

/// Variable with the folder into which each test writes its calls, for the coverage of a dossier.
pub(crate) const RECORD: &str = "BESSEMER_RECORD";

/// Writes the calls of a test, if a dossier requests them. A failure only makes the coverage smaller.
fn record(entry: &str, calls: &[Vec<u64>]) {
    let Some(folder) = std::env::var_os(RECORD) else { return };
    let text = serde_json::json!({ "entry": entry, "calls": calls }).to_string();
    let name = bessemer_dossier::manifest::hash(text.as_bytes());
    let _ = std::fs::write(Path::new(&folder).join(name), text);
}

/// Reads the calls that tests wrote, by entry point.
pub(crate) fn recorded(folder: &Path) -> Vec<(String, Vec<Vec<u64>>)> {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<_> = files.map(|file| file.path()).collect();
    paths.sort();
    let read = |path: &std::path::PathBuf| {
        let text = std::fs::read_to_string(path).ok()?;
        let json: serde_json::Value = serde_json::from_str(&text).ok()?;
        let words = |call: &serde_json::Value| {
            call.as_array()?.iter().map(serde_json::Value::as_u64).collect::<Option<Vec<u64>>>()
        };
        let calls = json["calls"].as_array()?.iter().map(words).collect::<Option<Vec<_>>>()?;
        Some((json["entry"].as_str()?.to_owned(), calls))
    };
    paths.iter().filter_map(read).collect()
}

/// Compares the legs for the package in this folder.
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
    record(entry.as_deref().unwrap_or_default(), &calls);
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
