//! Entry of `cargo bessemer`: reads the arguments, hands over, turns the outcome into an exit code.
//!
//! Invariant: no decision is taken here; everything else is in the library, where tests reach it.

use std::io::IsTerminal;
use std::path::Path;
use std::process::ExitCode;

use bessemer_project::{Wanted, generate, said};
use cargo_bessemer::args::{Arguments, MessageFormat, Task};
use cargo_bessemer::error::Error;
use cargo_bessemer::{asap2, doctor, explain, fmu, new, pack, python, sizes, verify};
use clap::Parser;

fn main() -> ExitCode {
    match perform(Arguments::parse().task()) {
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

/// The text to print, and whether all is well.
fn perform(task: Task) -> Result<(String, bool), Error> {
    let here = Path::new(".");
    let colour = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    match task {
        Task::Gen(it) => {
            let wanted =
                Wanted { package: it.package.name(), check: it.check, explain: it.explain, colour };
            let for_tools = it.message_format == MessageFormat::Json;
            let said = said(generate(here, wanted), for_tools)?;
            anstream::eprint!("{}", said.remarks);
            Ok((said.text, said.good))
        }
        Task::Explain(it) => Ok((explain::run(here, &it, colour)?, true)),
        Task::Verify(it) => verify::run(here, &it, colour),
        Task::Sizes(it) => Ok((sizes::run(here, &it, colour)?, true)),
        Task::New(it) => Ok((new::run(here, &it)?, true)),
        Task::Pack(it) => Ok((pack::run(here, &it, colour)?, true)),
        Task::Fmu(it) => Ok((fmu::run(here, &it, colour)?, true)),
        Task::Py(it) => Ok((python::run(here, &it, colour)?, true)),
        Task::A2l(it) => Ok((asap2::run(here, &it, colour)?, true)),
        Task::Doctor(it) => Ok(doctor::run(here, it.package.name(), &doctor::ThisMachine)),
    }
}
