//! Entry of `cargo bessemer`: parses the arguments, runs the command, and converts its outcome to an exit code.
//!
//! Invariant: no decisions are made here; everything else is in the library, where tests reach it.

use std::path::Path;
use std::process::ExitCode;

use cargo_bessemer::args::Arguments;
use cargo_bessemer::perform;
use clap::Parser;

fn main() -> ExitCode {
    match perform(Path::new("."), Arguments::parse().task()) {
        Ok((text, good)) => {
            anstream::print!("{text}");
            if good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(error) => {
            error.print();
            ExitCode::FAILURE
        }
    }
}
