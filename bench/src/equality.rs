//! Compares the elementary functions on all legs at millions of points. The legs are Rust, the C of each compiler,
//! and the C on the emulated Cortex-A9.
//!
//! Each leg hashes the bits of its results, a thousand points at a time (`tests/mathematics/probe.rs`, which every
//! leg runs), so that only the hashes are compared.

#[path = "../../tests/mathematics/probe.rs"]
mod probe;

use std::fmt::Write as _;
use std::thread;

use bessemer_codegen::compile::Compiled;
use bessemer_tests::entry;
use bessemer_tests::process::Process;
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::workspace::Workspace;
use probe::{POINTS, Probe};
use serde_json::{Value, json};

/// Number of functions in the probe.
const FUNCTIONS: u32 = 23;

/// Result of one leg.
#[derive(Clone, Debug)]
pub struct Leg {
    /// Name of the leg, such as `Rust` or `gcc -O2`.
    pub name: String,
    /// Hash of all results.
    pub folded: u64,
    /// The first call whose hash differs from the Rust's: function and number of the call.
    pub parted: Option<(u32, u32)>,
}

/// Runs `calls` calls of a thousand points for each function and format on every leg.
///
/// # Errors
/// What a tool said.
pub fn measure(calls: u32) -> Result<Vec<Leg>, String> {
    let text = format!("#![no_std]\n{}", include_str!("../../tests/mathematics/probe.rs"));
    let workspace = Workspace::with_source(&text).map_err(|error| error.to_string())?;
    let compiled = &workspace.compiled()?;
    let mut probe = Probe::default();
    let native: Vec<u64> = all(calls).map(|(which, call)| probe.step(which, range(call))).collect();
    let native = &native;
    let mut legs = vec![Leg { name: "Rust".into(), folded: folded(native), parted: None }];
    let mut toolchains = toolchain::all();
    // -O1 too, which the tests leave out.
    let more =
        toolchains.iter().filter(|it| it.level == 0).map(|it| Toolchain { level: 1, ..it.clone() });
    let more: Vec<Toolchain> = more.collect();
    toolchains.extend(more);
    for pair in toolchains.chunks(2) {
        let ran: Vec<Result<Vec<u64>, String>> = thread::scope(|scope| {
            let running: Vec<_> = (pair.iter())
                .map(|toolchain| scope.spawn(move || in_c(compiled, toolchain, calls)))
                .collect();
            let ended = running.into_iter().map(|one| one.join());
            ended.map(|it| it.unwrap_or_else(|_| Err("a leg panicked".into()))).collect()
        });
        for (toolchain, words) in pair.iter().zip(ran) {
            let words = words?;
            let parted = native.iter().zip(&words).position(|(rust, c)| rust != c);
            let parted = parted.map(|at| (at as u32 / calls, at as u32 % calls));
            eprintln!("{}: {parted:?}", toolchain.name());
            legs.push(Leg { name: toolchain.name(), folded: folded(&words), parted });
        }
    }
    Ok(legs)
}

fn all(calls: u32) -> impl Iterator<Item = (u32, u32)> {
    (0..FUNCTIONS).flat_map(move |which| (0..calls).map(move |call| (which, call)))
}

/// The range of a call's arguments.
fn range(call: u32) -> f64 {
    [1.0, 12.5, 750.0, 1e6, 1e12, 1e-3][call as usize % 6]
}

fn in_c(compiled: &Compiled, toolchain: &Toolchain, calls: u32) -> Result<Vec<u64>, String> {
    let step = entry(compiled, "Probe", "step").ok_or("the probe has no step")?;
    let mut process =
        Process::start(compiled, step, toolchain).map_err(|error| error.to_string())?;
    let said = all(calls).map(|(which, call)| {
        let words = process.step(&[which.into(), range(call).to_bits()]);
        words.map(|words| words[1]).map_err(|error| error.to_string())
    });
    said.collect()
}

fn folded(words: &[u64]) -> u64 {
    words.iter().fold(0, |sum, word| {
        let mixed = (sum ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        mixed ^ (mixed >> 29)
    })
}

/// Formats the results for machines.
pub fn json(legs: &[Leg], calls: u32) -> Value {
    json!({
        "command": "cargo xtask bench --only equality",
        "functions": FUNCTIONS,
        "points_of_each_in_f64_and_in_f32": u64::from(calls) * u64::from(POINTS),
        "legs": legs.iter().map(|leg| json!({
            "leg": leg.name,
            "folded_bits": format!("{:016x}", leg.folded),
            "equal": leg.parted.is_none(),
        })).collect::<Vec<_>>(),
    })
}

/// Formats the results for people.
pub fn table(legs: &[Leg]) -> String {
    let mut text = String::new();
    for leg in legs {
        let parted = leg.parted.map_or(String::new(), |at| format!("  parts at {at:?}"));
        let _ = writeln!(text, "{:<32} {:016x}{parted}", leg.name, leg.folded);
    }
    text
}
