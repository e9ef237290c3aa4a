//! `cargo xtask bench`: runs the measurements and writes their results.

use std::process::ExitCode;

use bench::check_cost::{self, Size};
use clap::Parser;
use indicatif::ProgressBar;

/// Measures what the attributes cost, and writes bench/results/check-cost.json.
#[derive(Parser)]
#[command(name = "cargo xtask bench")]
struct Arguments {
    /// A short run; nothing is written
    #[arg(long)]
    quick: bool,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let size = if arguments.quick {
        Size { functions: 200, runs: 3 }
    } else {
        Size { functions: 200, runs: 15 }
    };
    let bar = ProgressBar::new(2 * size.runs as u64).with_message("cargo check");
    let cost = match check_cost::measure(size, || bar.inc(1)) {
        Ok(cost) => cost,
        Err(error) => {
            eprintln!("error: {error}");
            return ExitCode::FAILURE;
        }
    };
    bar.finish_and_clear();
    print!("{}", cost.table());
    println!(
        "\nThe comparison with handwritten C comes with the linear algebra; it is not built yet."
    );
    if arguments.quick {
        return ExitCode::SUCCESS;
    }
    let path = bessemer_tests::root().join("bench/results/check-cost.json");
    let text = format!("{:#}\n", cost.json());
    let written = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    if let Err(error) = written.and_then(|()| std::fs::write(&path, text)) {
        eprintln!("error: `{}`: {error}", path.display());
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
