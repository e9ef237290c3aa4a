//! `cargo xtask bench`: runs the measurements and writes their results.

use std::process::ExitCode;

use bench::check_cost::{self, Size};
use bench::{elementary, equality};
use clap::{Parser, ValueEnum};
use indicatif::ProgressBar;
use serde_json::Value;

/// Measures, and writes bench/results/.
#[derive(Parser)]
#[command(name = "cargo xtask bench")]
struct Arguments {
    /// A short run; nothing is written
    #[arg(long)]
    quick: bool,
    /// Only this one
    #[arg(long)]
    only: Option<Part>,
    /// Points of each function for `equality`
    #[arg(long, default_value_t = 10_000_000)]
    points: u32,
}

/// What there is to measure.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    /// What the attributes cost
    CheckCost,
    /// The elementary functions against glibc and newlib
    Elementary,
    /// The elementary functions on ten million points each, on every leg: an hour
    Equality,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    // An hour only for those who ask.
    let wanted = |part| arguments.only.map_or(part != Part::Equality, |only| only == part);
    let parts: [(Part, &str, fn(&Arguments) -> Result<Value, String>); 3] = [
        (Part::CheckCost, "check-cost", check_cost),
        (Part::Elementary, "elementary", elementary),
        (Part::Equality, "equality", equality),
    ];
    for (_, name, measure) in parts.into_iter().filter(|(part, ..)| wanted(*part)) {
        let done = measure(&arguments)
            .and_then(|json| if arguments.quick { Ok(()) } else { write(name, &json) });
        if let Err(error) = done {
            eprintln!("error: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn check_cost(Arguments { quick, .. }: &Arguments) -> Result<Value, String> {
    let size = Size { functions: 200, runs: if *quick { 3 } else { 15 } };
    let bar = ProgressBar::new(2 * size.runs as u64).with_message("cargo check");
    let cost = check_cost::measure(size, || bar.inc(1))?;
    bar.finish_and_clear();
    print!("{}", cost.table());
    Ok(cost.json())
}

fn elementary(Arguments { quick, .. }: &Arguments) -> Result<Value, String> {
    let rows = elementary::measure(if *quick { 101 } else { 1001 })?;
    print!("{}", elementary::table(&rows));
    Ok(elementary::json(&rows))
}

fn equality(Arguments { quick, points, .. }: &Arguments) -> Result<Value, String> {
    let calls = if *quick { 100 } else { points.div_ceil(1_000) };
    let legs = equality::measure(calls)?;
    print!("{}", equality::table(&legs));
    let json = equality::json(&legs, calls);
    match legs.iter().find(|leg| leg.parted.is_some()) {
        Some(leg) => Err(format!("{} differs from the Rust", leg.name)),
        None => Ok(json),
    }
}

fn write(name: &str, json: &Value) -> Result<(), String> {
    let path = bessemer_tests::root().join(format!("bench/results/{name}.json"));
    let written = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    let written = written.and_then(|()| std::fs::write(&path, format!("{json:#}\n")));
    written.map_err(|error| format!("`{}`: {error}", path.display()))
}
