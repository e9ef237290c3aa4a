//! The drone's campaigns as a program of their own, for `cargo bessemer campaign -p sim` and its engines.

use std::process::ExitCode;

fn main() -> ExitCode {
    bessemer_campaign::main(&sim::campaign::ALL)
}
