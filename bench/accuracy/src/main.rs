//! Measures the elementary functions against MPFR: the worst error found of each, in units in the
//! last place of the true value.
//!
//! `cargo run --release --manifest-path bench/accuracy/Cargo.toml -- [points per function] [name]`
//! writes `bench/results/accuracy.json`, the table in `docs/mathematics.md`, and the points that the
//! tests keep, `dsl/tests/data/reference.txt`. With a name it only prints.

mod points;
mod subjects;

use std::fmt::Write as _;
use std::path::Path;
use std::thread;

use points::{Points, SEQUENCES};
use rug::Float;
use subjects::{Of, SUBJECTS, Subject};

/// Precision of the reference, in bits: enough for a correctly rounded result to within 2⁻⁷⁰ ulp.
const PRECISION: u32 = 128;
/// Number of points kept for the tests for each function: the worst, and others.
const KEPT: usize = 24;

/// A point and the error of the function there.
#[derive(Clone, Copy, Debug, Default)]
struct Finding {
    ulp: f64,
    x: f64,
    y: f64,
}

#[derive(Clone, Debug, Default)]
struct Findings {
    double: Vec<Finding>,
    single: Vec<Finding>,
    points: u64,
}

/// The true value of a function.
fn truth(subject: &Subject, x: f64, y: f64) -> Float {
    let mut value = Float::with_val(PRECISION, x);
    match subject.truth {
        Of::One(truth) => truth(&mut value),
        Of::Two(truth) => truth(&mut value, &Float::with_val(PRECISION, y)),
    }
    value
}

/// The error of `value` in ulp, for a format with `digits` bits and the lowest exponent `least`.
fn error(value: f64, truth: &Float, digits: i32, least: i32, largest: f64) -> f64 {
    if value.is_nan() || truth.is_nan() {
        return if value.is_nan() && truth.is_nan() { 0.0 } else { f64::INFINITY };
    }
    if truth.is_infinite() || value.is_infinite() || truth.is_zero() {
        let expected = if digits == 53 { truth.to_f64() } else { f64::from(truth.to_f32()) };
        if value == expected {
            return 0.0;
        }
        if value.is_finite() || truth.clone().abs() < largest {
            return f64::INFINITY;
        }
    }
    let exponent = truth.get_exp().unwrap_or(least) - digits;
    let mut difference = Float::with_val(PRECISION, truth - value);
    difference >>= exponent.max(least);
    difference.to_f64().abs()
}

fn note(list: &mut Vec<Finding>, found: Finding) {
    if list.len() < KEPT || list.last().is_some_and(|last| found.ulp > last.ulp) {
        let at = list.partition_point(|other| other.ulp >= found.ulp);
        list.insert(at, found);
        list.truncate(KEPT);
    }
}

fn measure(subject: &Subject, count: u64, seed: u64) -> Findings {
    let mut findings = Findings::default();
    let mut points = Points::new(seed);
    for index in 0..count {
        let (x, y) = points.next(subject.domain(), index);
        let value = match subject.double {
            Of::One(double) => double(x),
            Of::Two(double) => double(x, y),
        };
        let ulp = error(value, &truth(subject, x, y), 53, -1074, f64::MAX);
        note(&mut findings.double, Finding { ulp, x, y });

        let (x, y) = (x as f32, y as f32);
        let value = match subject.single {
            Of::One(single) => single(x),
            Of::Two(single) => single(x, y),
        };
        let (wide_x, wide_y) = (f64::from(x), f64::from(y));
        let largest = f64::from(f32::MAX);
        let ulp = error(value.into(), &truth(subject, wide_x, wide_y), 24, -149, largest);
        note(&mut findings.single, Finding { ulp, x: wide_x, y: wide_y });
        findings.points += 1;
    }
    findings
}

fn measured(subject: &Subject, count: u64) -> Findings {
    let mut all = Findings::default();
    thread::scope(|scope| {
        let parts: Vec<_> = (0..SEQUENCES)
            .map(|seed| scope.spawn(move || measure(subject, count / SEQUENCES, seed)))
            .collect();
        for part in parts {
            let part = part.join().expect("a measurement does not panic");
            part.double.into_iter().for_each(|found| note(&mut all.double, found));
            part.single.into_iter().for_each(|found| note(&mut all.single, found));
            all.points += part.points;
        }
    });
    all
}

fn argument(subject: &Subject, found: &Finding, single: bool) -> String {
    let one = |x: f64| if single { format!("{:e}", x as f32) } else { format!("{x:e}") };
    match subject.double {
        Of::One(_) => one(found.x),
        Of::Two(_) => format!("{}, {}", one(found.x), one(found.y)),
    }
}

/// Lists each point kept, as bits: name, arguments, the true value rounded, and its rounding error in ulp.
fn reference(subject: &Subject, findings: &Findings, text: &mut String) {
    let mut points = Points::new(99);
    let more: Vec<(f64, f64)> =
        (0..2 * KEPT as u64).map(|i| points.next(subject.domain(), 7 * i)).collect();
    let worst = findings.double.iter().map(|found| (found.x, found.y));
    for (x, y) in worst.chain(more) {
        let truth = truth(subject, x, y);
        let high = truth.to_f64();
        if !high.is_finite() {
            continue;
        }
        let mut left = Float::with_val(PRECISION, &truth - high);
        left >>= (truth.get_exp().unwrap_or(-1074) - 53).max(-1074);
        let _ = writeln!(
            text,
            "{} {:016x} {:016x} {:016x} {:016x}",
            subject.name,
            x.to_bits(),
            y.to_bits(),
            high.to_bits(),
            left.to_f64().to_bits()
        );
    }
}

fn main() -> std::io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let count = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(1_000_000);
    let only = arguments.next();
    let (mut json, mut table, mut kept) = (String::new(), String::new(), String::new());
    for subject in SUBJECTS.iter().filter(|it| only.as_ref().is_none_or(|only| only == it.name)) {
        let findings = measured(subject, count);
        let (double, single) = (findings.double[0], findings.single[0]);
        let (at, at_single) = (argument(subject, &double, false), argument(subject, &single, true));
        println!(
            "{:7} {:.4} at {at}; f32 {:.4} at {at_single}",
            subject.name, double.ulp, single.ulp
        );
        let _ = writeln!(
            table,
            "| `{}` | {:.3} | {at} | {:.4} | {at_single} |",
            subject.name, double.ulp, single.ulp
        );
        let comma = if json.is_empty() { "" } else { ",\n" };
        let _ = write!(
            json,
            "{comma}    {{ \"function\": \"{}\", \"points\": {}, \"f64\": {{ \"ulp\": {:.4}, \"at\": \"{at}\" }}, \
             \"f32\": {{ \"ulp\": {:.4}, \"at\": \"{at_single}\" }} }}",
            subject.name, findings.points, double.ulp, single.ulp
        );
        reference(subject, &findings, &mut kept);
    }
    if only.is_some() {
        return Ok(());
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    std::fs::create_dir_all(root.join("bench/results"))?;
    std::fs::write(
        root.join("bench/results/accuracy.json"),
        format!(
            "{{\n  \"reference\": \"MPFR, {PRECISION} bits\",\n  \"functions\": [\n{json}\n  ]\n}}\n"
        ),
    )?;
    std::fs::create_dir_all(root.join("dsl/tests/data"))?;
    std::fs::write(root.join("dsl/tests/data/reference.txt"), kept)?;
    let page = root.join("docs/mathematics.md");
    let text = std::fs::read_to_string(&page)?;
    let (start, end) = ("<!-- accuracy -->\n", "<!-- end of accuracy -->");
    if let (Some(from), Some(to)) = (text.find(start), text.find(end)) {
        let (before, after) = (&text[..from + start.len()], &text[to..]);
        let head = "| function | f64: ulp | at | f32: ulp | at |\n|---|---|---|---|---|\n";
        let note = format!("\n{count} points for each function and format.\n\n");
        std::fs::write(page, format!("{before}{note}{head}{table}{after}"))?;
    }
    Ok(())
}
