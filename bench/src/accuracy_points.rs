//! Compares the elementary functions on all legs at the points of the accuracy measurement. The legs are Rust, the C
//! of each compiler, and the C on the emulated Cortex-A9.
//!
//! The points of a function are written to a file that every leg reads; the results are combined into a hash.
//! [`crate::equality`] draws its points in the models instead.

#[path = "../accuracy/src/points.rs"]
mod points;

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::thread;

use bessemer::math::{
    arctangent, exponential, hyperbolic, logarithm, power, roots, sine, single, tangent,
};
use bessemer_tests::toolchain::{self, Toolchain};
use points::{DOMAINS, Domain, Points, SEQUENCES};
use serde_json::{Value, json};

use crate::elementary::{self, Emission};

/// Result of one leg.
#[derive(Clone, Debug)]
pub struct Leg {
    /// Name of the leg, such as `Rust` or `gcc -O2`.
    pub name: String,
    /// Hash of the result bits of each function, in the order of [`names`].
    pub folded: Vec<u64>,
}

/// The functions.
pub fn names() -> impl Iterator<Item = &'static str> {
    DOMAINS.iter().map(|domain| domain.name)
}

/// A function in both formats.
enum Native {
    One(fn(f64) -> f64, fn(f32) -> f32),
    Two(fn(f64, f64) -> f64, fn(f32, f32) -> f32),
}

fn native(name: &str) -> Option<Native> {
    use Native::{One, Two};
    Some(match name {
        "sin" => One(sine::sin, single::sinf),
        "cos" => One(sine::cos, single::cosf),
        "tan" => One(tangent::tan, single::tanf),
        "asin" => One(arctangent::asin, single::asinf),
        "acos" => One(arctangent::acos, single::acosf),
        "atan" => One(arctangent::atan, single::atanf),
        "atan2" => Two(arctangent::atan2, single::atan2f),
        "exp" => One(exponential::exp, single::expf),
        "exp2" => One(exponential::exp2, single::exp2f),
        "exp_m1" => One(exponential::exp_m1, single::exp_m1f),
        "ln" => One(logarithm::ln, single::lnf),
        "log2" => One(logarithm::log2, single::log2f),
        "log10" => One(logarithm::log10, single::log10f),
        "ln_1p" => One(logarithm::ln_1p, single::ln_1pf),
        "sinh" => One(hyperbolic::sinh, single::sinhf),
        "cosh" => One(hyperbolic::cosh, single::coshf),
        "tanh" => One(hyperbolic::tanh, single::tanhf),
        "powf" => Two(power::powf, single::powff),
        "cbrt" => One(roots::cbrt, single::cbrtf),
        "hypot" => Two(roots::hypot, single::hypotf),
        _ => return None,
    })
}

impl Native {
    fn fold(&self, folded: u64, x: f64, y: f64) -> u64 {
        let (wide, narrow) = match self {
            Native::One(wide, narrow) => (wide(x), narrow(x as f32)),
            Native::Two(wide, narrow) => (wide(x, y), narrow(x as f32, y as f32)),
        };
        let wide = if wide.is_nan() { u64::MAX } else { wide.to_bits() };
        let narrow = if narrow.is_nan() { u32::MAX } else { narrow.to_bits() };
        fold(fold(folded, wide), narrow.into())
    }
}

fn fold(folded: u64, bits: u64) -> u64 {
    let mixed = (folded ^ bits).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    mixed ^ (mixed >> 29)
}

/// Runs every leg on `count` points of each function.
///
/// # Errors
///
/// The message of a tool or the system.
pub fn measure(count: u64) -> Result<Vec<Leg>, String> {
    let emission = &elementary::emission()?;
    let here = emission.folder();
    let failed = |error: io::Error| error.to_string();
    fs::write(here.join("points.c"), include_str!("elementary/points.c")).map_err(failed)?;
    fs::write(here.join("subjects.h"), emission.headers()).map_err(failed)?;
    fs::write(here.join("functions.inc"), cases(emission)?).map_err(failed)?;

    let mut legs = vec![Leg { name: "Rust".into(), folded: Vec::new() }];
    let mut programs = Vec::new();
    for (number, toolchain) in toolchains().into_iter().enumerate() {
        let program = here.join(format!("points_{number}"));
        let sources = emission.sources();
        toolchain.around(&here.join("points.c"), sources, &program, &["-std=gnu99"])?;
        legs.push(Leg { name: toolchain.name(), folded: Vec::new() });
        programs.push((toolchain, program));
    }

    let file = here.join("points.bin");
    for (which, domain) in DOMAINS.iter().enumerate() {
        legs[0].folded.push(write(domain, count, &file).map_err(failed)?);
        let said = ran(&programs, which, &file);
        for (leg, folded) in legs[1..].iter_mut().zip(said) {
            leg.folded.push(folded?);
        }
        let equal = legs.iter().all(|leg| leg.folded[which] == legs[0].folded[which]);
        eprintln!("{:<8} {}", domain.name, if equal { "equal" } else { "parts" });
    }
    Ok(legs)
}

/// Each compiler at each level on this machine, and the Cortex-A9.
fn toolchains() -> Vec<Toolchain> {
    let mut all = toolchain::host();
    let first = all.iter().filter(|it| it.level == 0);
    let first: Vec<_> = first.map(|it| Toolchain { level: 1, ..it.clone() }).collect();
    all.extend(first);
    all.extend(toolchain::target().into_iter().filter(|it| it.level == 2));
    all
}

fn cases(emission: &Emission) -> Result<String, String> {
    let mut text = String::new();
    for (number, domain) in DOMAINS.iter().enumerate() {
        let wide = emission.name(domain.name)?;
        let narrow = emission.name(&format!("{}f", domain.name))?;
        let kind = if matches!(native(domain.name), Some(Native::Two(..))) { "B" } else { "U" };
        let _ = writeln!(text, "{kind}({number}, {wide}, {narrow})");
    }
    Ok(text)
}

/// Writes the points of a function to a file; returns the hash of the Rust results.
fn write(domain: &Domain, count: u64, file: &Path) -> io::Result<u64> {
    let native = native(domain.name).ok_or_else(|| io::Error::other(domain.name))?;
    let mut out = BufWriter::new(File::create(file)?);
    let mut folded = 0;
    for seed in 0..SEQUENCES {
        let mut points = Points::new(seed);
        for index in 0..count / SEQUENCES {
            let (x, y) = points.next(domain, index);
            out.write_all(&x.to_le_bytes())?;
            out.write_all(&y.to_le_bytes())?;
            folded = native.fold(folded, x, y);
        }
    }
    out.flush()?;
    Ok(folded)
}

/// Runs the programs in parallel, one per processor, and returns their outputs.
fn ran(programs: &[(Toolchain, PathBuf)], which: usize, file: &Path) -> Vec<Result<u64, String>> {
    let at_once = thread::available_parallelism().map_or(1, usize::from);
    let mut all = Vec::new();
    for some in programs.chunks(at_once) {
        thread::scope(|scope| {
            let running: Vec<_> = some
                .iter()
                .map(|(toolchain, program)| {
                    scope.spawn(move || run(toolchain, program, which, file))
                })
                .collect();
            let ended = running.into_iter().map(|one| one.join());
            all.extend(ended.map(|it| it.unwrap_or_else(|_| Err("a leg panicked".into()))));
        });
    }
    all
}

fn run(toolchain: &Toolchain, program: &Path, which: usize, file: &Path) -> Result<u64, String> {
    let said = |error: io::Error| format!("{}: {error}", toolchain.name());
    let points = File::open(file).map_err(said)?;
    let mut command = toolchain.runner(program);
    let output = command.arg(which.to_string()).stdin(Stdio::from(points)).output();
    let text = String::from_utf8_lossy(&output.map_err(said)?.stdout).into_owned();
    u64::from_str_radix(text.trim(), 16)
        .map_err(|error| format!("{}: `{text}`: {error}", toolchain.name()))
}

/// Formats the results for machines.
pub fn json(legs: &[Leg], count: u64) -> Value {
    let words = |leg: &Leg| leg.folded.iter().map(|it| format!("{it:016x}")).collect::<Vec<_>>();
    json!({
        "command": "cargo xtask bench --only accuracy-points",
        "points": "those of bench/results/accuracy.json, in f64 and in f32",
        "points_of_each": count,
        "functions": names().collect::<Vec<_>>(),
        "legs": legs.iter().map(|leg| json!({
            "leg": leg.name,
            "folded_bits": words(leg),
            "equal": leg.folded == legs[0].folded,
        })).collect::<Vec<_>>(),
    })
}

/// Formats the results for people.
pub fn table(legs: &[Leg]) -> String {
    let mut text = String::new();
    for leg in legs {
        let parted = names().zip(leg.folded.iter().zip(&legs[0].folded));
        let parted: Vec<_> = parted.filter(|(_, (c, rust))| c != rust).map(|it| it.0).collect();
        let verdict = if parted.is_empty() { "equal".into() } else { parted.join(" ") };
        let _ = writeln!(text, "{:<32} {verdict}", leg.name);
    }
    text
}
