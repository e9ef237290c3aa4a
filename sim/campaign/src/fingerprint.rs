//! The hash of sources, which distinguishes the files of different models.
//!
//! Knows no Rust syntax: a line that begins with `//`, an empty one, and a `#[requirement(…)]` do not count. So a better comment
//! changes no hash, and neither does a named requirement, which changes no program.

use sha2::{Digest, Sha256};
use std::fmt::Write as _;

/// Returns the hash of the texts of the models, usually `include_str!("../src/lib.rs")` and its like: 32 hexadecimal digits.
///
/// ```
/// use bessemer_campaign::fingerprint;
///
/// let models = fingerprint(&["/// Doubles.\nfn double(x: f64) -> f64 {\n    2.0 * x\n}"]);
/// assert_eq!(models, fingerprint(&["fn double(x: f64) -> f64 {\n    2.0 * x\n}\n"]));
/// assert_ne!(models, fingerprint(&["fn double(x: f64) -> f64 {\n    3.0 * x\n}\n"]));
/// ```
pub fn fingerprint(sources: &[&str]) -> String {
    let mut hash = Sha256::new();
    for source in sources {
        let lines = source.lines().map(str::trim);
        for line in lines.filter(|line| counts(line)) {
            hash.update(line.as_bytes());
            hash.update(b"\n");
        }
        hash.update([0]);
    }
    let mut text = String::new();
    for byte in &hash.finalize()[..16] {
        let _ = write!(text, "{byte:02x}");
    }
    text
}

/// Returns true for a line that belongs to the program.
fn counts(line: &str) -> bool {
    let names_requirements = line.starts_with("#[requirement(") && line.ends_with(")]");
    !line.is_empty() && !line.starts_with("//") && !names_requirements
}
