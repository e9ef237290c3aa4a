//! The program behind `cargo xtask sim`, `identify` and `campaign`.

mod commands;

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
        Task::Sim(wanted) => commands::fly::run(&wanted),
        Task::Identify(wanted) => commands::identify::run(&wanted),
        Task::Campaign(wanted) => commands::campaign::run(&wanted),
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
