//! The program behind `cargo xtask sim`, `identify` and `campaign`.

mod program;

use clap::Parser;
use sim_args::Task;
use std::process::ExitCode;

/// Flies, identifies, and flies very often.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().task {
        Task::Sim(wanted) => program::fly::run(&wanted),
        Task::Identify(wanted) => program::identify::run(&wanted),
        Task::Campaign(wanted) => program::campaign::run(&wanted),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}
