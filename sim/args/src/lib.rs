//! The command lines of the simulation: commands, arguments and help texts.
//!
//! A separate crate, so that xtask can print help and report mistakes without building the plant.
//!
//! Invariant: only data and help texts; nothing is executed here.

use clap::{Args, Subcommand, ValueEnum};
use std::path::PathBuf;

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Task {
    /// Fly a flight of the onboard software against the simulated aircraft
    Sim(Fly),
    /// Identify the thrust coefficients of a logged flight
    Identify(Identify),
    /// Fly very many flights: chance, failures
    Campaign(Campaign),
}

const FLY: &str = "\
Examples:
  cargo xtask sim --list                  The flights, and what each shows
  cargo xtask sim hover                   Fly one with the Rust models
  cargo xtask sim hover --c               The same with their C, to the same bits
  cargo xtask sim hover --c --target zynq The same on an emulated Zynq, over its serial line (examples/zynq)
  cargo xtask sim hover --out target/hover
                                          Also write CSV, MCAP (Foxglove, PlotJuggler) and pictures
  cargo xtask sim all                     Fly them all";

/// Arguments of `sim`.
#[derive(Debug, Args)]
#[command(after_help = FLY)]
pub struct Fly {
    /// The flight, or `all`; without it, the flights are listed
    pub flight: Option<String>,
    /// List the flights
    #[arg(long)]
    pub list: bool,
    /// Seed of all randomness
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Write CSV, MCAP and SVG into this folder
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Also fly the emitted C (gcc), and compare every output and every state by its bits
    #[arg(long)]
    pub c: bool,
    /// Machine that runs the C
    #[arg(long, value_enum, default_value_t = Machine::Native, requires = "c")]
    pub target: Machine,
}

/// Machine that runs the C.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Machine {
    /// This machine
    Native,
    /// An emulated Zynq without an operating system (qemu-system-arm)
    Zynq,
}

const IDENTIFY: &str = "\
Examples:
  cargo xtask sim hover --out target/hover
  cargo xtask identify target/hover/hover.mcap --out target/hover
      Coefficients with their confidence, the convergence (fig. 5.2), the model against the flight (fig. 5.3)
  cargo xtask identify target/hover/hover.mcap --no-swarm --costs 4000
      Also how long so many costs of each kind take
  cargo xtask identify --study 20 --file docs/results/identification.csv
      Simulated flights whose coefficients are known: how far each method is off";

/// Arguments of `identify`.
#[derive(Debug, Args)]
#[command(after_help = IDENTIFY)]
pub struct Identify {
    /// A flight, as `cargo xtask sim FLIGHT --out FOLDER` writes it
    #[arg(required_unless_present = "study")]
    pub flight: Option<PathBuf>,
    /// Seed of the swarm
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Write the pictures into this folder
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Also measure the time of this many costs of each kind, around the found coefficients
    #[arg(long, value_name = "COUNT")]
    pub costs: Option<u32>,
    /// Leave the thesis' swarm out
    #[arg(long)]
    pub no_swarm: bool,
    /// Identify this many simulated flights with known coefficients
    #[arg(long, conflicts_with = "flight")]
    pub study: Option<u64>,
    /// File that stores the study
    #[arg(long, requires = "study")]
    pub file: Option<PathBuf>,
}

const CAMPAIGN: &str = "\
Examples:
  cargo xtask campaign spread --seeds 0..1000 --file target/spread.csv
  cargo xtask campaign failures --seeds 0..200 --file target/failures.csv
      Stopped and started again, a campaign flies what its file does not hold yet.
  cargo xtask campaign spread --shard 2/4 --file shard-2.csv
      One of four shards, for a scheduler.
  cargo xtask campaign spread --merge shard-1.csv shard-2.csv shard-3.csv shard-4.csv
      What all shards come to.
  cargo xtask campaign spread --file target/spread.csv --summary target/spread.html
      Also a page with distributions and the worst seeds.

A file has the hash of the models, and takes no flights of others.";

/// Arguments of `campaign`.
#[derive(Debug, Args)]
#[command(after_help = CAMPAIGN)]
pub struct Campaign {
    /// Subject of the campaign
    pub kind: Subject,
    /// The seeds, from .. to (without the last)
    #[arg(long, default_value = "0..1000")]
    pub seeds: String,
    /// Fly one of several shards of the seeds: 1/4 … 4/4
    #[arg(long, value_name = "I/N")]
    pub shard: Option<String>,
    /// File that stores the flights, one per line
    #[arg(long, required_unless_present = "merge")]
    pub file: Option<PathBuf>,
    /// Fly nothing: print the results of the flights in these files
    #[arg(long, num_args = 1.., conflicts_with_all = ["file", "shard"])]
    pub merge: Vec<PathBuf>,
    /// With --merge: read flights of other models, with this hash
    #[arg(long, value_name = "HASH", requires = "merge")]
    pub accept: Option<String>,
    /// Write the summary as a page
    #[arg(long, value_name = "FILE.html")]
    pub summary: Option<PathBuf>,
}

/// Subject of a campaign.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Subject {
    /// Parameters, noise, wind and outages by chance: no flight may end badly
    Spread,
    /// Something breaks in each: every stop must be true, and none missed
    Failures,
}
