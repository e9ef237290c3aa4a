//! `cargo xtask bench`: runs the measurements and writes their results.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use bench::check_cost::{self, Size};
use bench::kernels::results::Results;
use bench::kernels::{plot, report, run};
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};

/// Measures the generated C against its peers, and what the attributes cost; writes bench/results/.
#[derive(Parser)]
#[command(name = "cargo xtask bench")]
struct Arguments {
    /// A short run; nothing is written
    #[arg(long)]
    quick: bool,
    /// Only the generated C
    #[arg(long, conflicts_with = "check_cost")]
    kernels: bool,
    /// Only what the attributes cost
    #[arg(long)]
    check_cost: bool,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match measure(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn measure(arguments: &Arguments) -> Result<(), String> {
    if !arguments.check_cost {
        kernels(arguments.quick)?;
    }
    // The short run has a minute for everything.
    if !arguments.kernels && (arguments.check_cost || !arguments.quick) {
        attributes(arguments.quick)?;
    }
    Ok(())
}

fn kernels(quick: bool) -> Result<(), String> {
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed:.dim} {wide_msg}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(std::time::Duration::from_millis(100));
    let plain = bar.is_hidden();
    let say = |line: &str| {
        bar.set_message(line.to_owned());
        // Off a terminal, a line for each step but the many cases.
        if plain && !line.contains("timing") {
            eprintln!("{line}");
        }
    };
    let plan = if quick { run::QUICK } else { run::FULL };
    let results = run::run(&plan, &say)?;
    bar.finish_and_clear();
    print!("{}", report::terminal(&results));
    if quick { Ok(()) } else { write(&results) }
}

fn write(results: &Results) -> Result<(), String> {
    let about = about();
    let folder = bessemer_tests::root().join("bench/results");
    put(&folder, "kernels.json", &format!("{:#}\n", results.json(&about)))?;
    put(&folder, "kernels.md", &report::markdown(results, &about))?;
    put(&folder, "chapter6.svg", &plot::chapter_6(results))?;
    put(&folder, "small.svg", &plot::small(results))
}

/// The machine and the compilers.
fn about() -> BTreeMap<&'static str, String> {
    let first = |program: &str| {
        let output = Command::new(program).arg("--version").output().ok()?;
        Some(String::from_utf8_lossy(&output.stdout).lines().next()?.to_owned())
    };
    let mut about = BTreeMap::from([("command", "cargo xtask bench".to_owned())]);
    let processor = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    if let Some(line) = processor.lines().find(|line| line.starts_with("model name")) {
        about.insert("processor", line.split(':').nth(1).unwrap_or_default().trim().to_owned());
    }
    let tools = [
        ("gcc", "gcc"),
        ("ARM gcc", "arm-linux-gnueabihf-gcc"),
        ("rustc", "rustc"),
        ("QEMU", "qemu-arm"),
        ("valgrind", "valgrind"),
    ];
    for (name, program) in tools {
        about.extend(first(program).map(|version| (name, version)));
    }
    about
}

fn attributes(quick: bool) -> Result<(), String> {
    let size = match quick {
        true => Size { functions: 200, runs: 3 },
        false => Size { functions: 200, runs: 15 },
    };
    let bar = ProgressBar::new(2 * size.runs as u64).with_message("cargo check");
    let cost = check_cost::measure(size, || bar.inc(1))?;
    bar.finish_and_clear();
    print!("\n{}", cost.table());
    match quick {
        true => Ok(()),
        false => {
            let folder = bessemer_tests::root().join("bench/results");
            put(&folder, "check-cost.json", &format!("{:#}\n", cost.json()))
        }
    }
}

fn put(folder: &Path, name: &str, text: &str) -> Result<(), String> {
    let path: PathBuf = folder.join(name);
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(&path, text))
        .map_err(|error| format!("`{}`: {error}", path.display()))
}
