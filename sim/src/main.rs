//! `cargo xtask sim`: flies a flight with the Rust models and says how it went.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use models::Parameters;
use sim::{Mission, Native, Tolerance, Vehicle, fly, report, verdict};

/// Flies the simulated aircraft with the Rust models.
#[derive(Parser)]
#[command(name = "cargo xtask sim")]
struct Arguments {
    /// The flight; without it, the flights are listed
    flight: Option<String>,
    /// Writes every step as comma-separated values
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

/// A flight by name.
struct Named {
    name: &'static str,
    what: &'static str,
    mission: fn() -> Mission,
}

const FLIGHTS: &[Named] = &[Named {
    name: "every-channel",
    what: "take off, hover at 1 m, turn by 90°, go 1 m, land; gusts on the way",
    mission: Mission::every_channel,
}];

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let Some(name) = arguments.flight else {
        for Named { name, what, .. } in FLIGHTS {
            println!("{name}  {what}");
        }
        return ExitCode::SUCCESS;
    };
    let Some(known) = FLIGHTS.iter().find(|known| known.name == name) else {
        eprintln!("error: there is no flight `{name}`; `cargo xtask sim` lists them");
        return ExitCode::from(2);
    };
    let (mission, parameters) = ((known.mission)(), Parameters::mambo());
    let flight = fly(&Vehicle::mambo(), &parameters, &mission, &mut Native::new(parameters));
    print!("{}", report::page(&flight, &mission, parameters.mixer.largest_command));
    if let Some(path) = arguments.csv
        && let Err(error) = std::fs::write(&path, report::csv(&flight))
    {
        eprintln!("error: `{}`: {error}", path.display());
        return ExitCode::FAILURE;
    }
    let good = verdict::judge(&flight, &mission, &Tolerance::default()).is_empty();
    if good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
