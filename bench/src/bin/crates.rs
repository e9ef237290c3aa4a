//! `cargo xtask crates`: tries the crates of the field, prints a table, and writes `bench/results/crates.json` and `docs/crates.md`.

use std::process::ExitCode;

use bench::crates::{self, HEAD, page};
use clap::Parser;

/// Tries crates of the field with attributes and imports alone; writes bench/results/crates.json and docs/crates.md.
#[derive(Parser)]
#[command(name = "cargo xtask crates")]
struct Arguments {
    /// Only these crates; the others keep their previous results
    names: Vec<String>,
    /// Print all errors of a crate that does not become C, and each step
    #[arg(long)]
    verbose: bool,
    /// Write nothing
    #[arg(long)]
    dry: bool,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let all = crates::all()?;
    let unknown = arguments.names.iter().find(|name| all.iter().all(|it| it.name != **name));
    if let Some(name) = unknown {
        return Err(format!("`{name}` is not in bench/crates/README.md"));
    }
    eprintln!("cargo fetches the sources");
    let sources = crates::vendored(&all)?;
    let wanted =
        |it: &&crates::Crate| arguments.names.is_empty() || arguments.names.contains(&it.name);
    let mut trials = Vec::new();
    println!("{HEAD}");
    for (at, one) in all.iter().filter(wanted).enumerate() {
        let say = |step: &str| eprintln!("{} {}: {step}", at + 1, one.name);
        let trial = crates::tried(one, &sources, &say);
        println!("{}", trial.line());
        if let (true, Err(said)) = (arguments.verbose, &trial.outcome) {
            println!("{said}");
        }
        trials.push(trial);
    }
    let passed = trials.iter().filter(|it| it.passes()).count();
    let plain = trials.iter().filter(|it| it.passes() && it.marks[2] == 0).count();
    println!(
        "{passed} of {} become C of the same bits, {plain} of them with attributes and imports alone",
        trials.len()
    );
    if arguments.dry {
        return Ok(());
    }
    crates::store(&trials)?;
    let page = page::path();
    std::fs::write(&page, page::text()?).map_err(|error| format!("`{}`: {error}", page.display()))
}
