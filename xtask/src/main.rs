//! Entry of `cargo xtask`: parses the arguments, runs the command, and converts its outcome to an exit code.
//!
//! Invariant: no decisions are made here; everything else is in the library, where tests reach it.

use std::process::ExitCode;

use clap::Parser;
use xtask::args::{Arguments, Task};
use xtask::error::{Error, Outcome};
use xtask::tools::ThisMachine;
use xtask::{bench, book, doctor, fuzz, generate, hand_over, mutate, project, test};

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match perform(&arguments.task) {
        Ok(Outcome::Good) => ExitCode::SUCCESS,
        Ok(Outcome::Bad) => ExitCode::FAILURE,
        Err(error) => {
            error.print();
            ExitCode::from(error.code())
        }
    }
}

fn perform(task: &Task) -> Result<Outcome, Error> {
    let root = project::root();
    match task {
        Task::Gen(wanted) => generate::run(&root, wanted),
        Task::Test(wanted) => test::run(&root, wanted, &ThisMachine),
        Task::Mutate(wanted) => mutate::run(&root, wanted),
        Task::Fuzz(wanted) => fuzz::run(&root, wanted),
        Task::Doctor(wanted) => doctor::run(wanted, &ThisMachine),
        Task::Bench(wanted) => bench::run(&root, wanted, &ThisMachine),
        Task::Crates(wanted) => bench::crates(&root, wanted, &ThisMachine),
        Task::Book => book::run(&root, &ThisMachine),
        Task::Simulation(_) => {
            hand_over::run(&root, &hand_over::SIMULATION, &[], std::env::args_os().skip(1))
        }
        Task::Ground(task) => {
            hand_over::run(&root, &hand_over::GROUND, &task.features(), std::env::args_os().skip(1))
        }
    }
}
