//! `cargo xtask campaign`: very many flights on all cores, and what they come to.

use super::Outcome;
use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use sim::campaign::ledger::{Ledger, outcomes};
use sim::campaign::{Kind, fly, tally};
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Mutex;

const EXAMPLES: &str = "\
Examples:
  cargo xtask campaign spread --seeds 0..1000 --file target/spread.csv
  cargo xtask campaign failures --seeds 0..200 --file target/failures.csv
      Stopped and started again, a campaign flies what its file does not hold yet.
  cargo xtask campaign spread --seeds 250..500 --file shard-2.csv
      One of four shards, for a scheduler.
  cargo xtask campaign spread --merge shard-1.csv shard-2.csv shard-3.csv shard-4.csv
      What all shards come to.";

/// Arguments of `campaign`.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Campaign {
    /// What it is about
    kind: Subject,
    /// The seeds, from .. to (without the last)
    #[arg(long, default_value = "0..1000", value_parser = range)]
    seeds: (u64, u64),
    /// Where the flights are written down, a line each
    #[arg(long, required_unless_present = "merge")]
    file: Option<PathBuf>,
    /// Fly nothing: tell what the flights in these files come to
    #[arg(long, num_args = 1.., conflicts_with = "file")]
    merge: Vec<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Subject {
    /// Parameters, noise, wind and outages by chance: no flight may end badly
    Spread,
    /// Something breaks in each: every stop must be true, and none missed
    Failures,
}

fn range(text: &str) -> Result<(u64, u64), String> {
    let (from, to) = text.split_once("..").ok_or("write it as 0..1000")?;
    let number = |text: &str| text.parse::<u64>().map_err(|error| format!("`{text}`: {error}"));
    Ok((number(from)?, number(to)?))
}

/// Flies what is missing, and tells what all come to.
pub fn run(wanted: &Campaign) -> Outcome {
    let kind = match wanted.kind {
        Subject::Spread => Kind::Spread,
        Subject::Failures => Kind::Failures,
    };
    let mut text = String::new();
    for path in wanted.file.iter().chain(&wanted.merge) {
        if wanted.merge.is_empty() {
            complete(kind, wanted.seeds, path)?;
        }
        let read = std::fs::read_to_string(path);
        text += &read.map_err(|error| format!("`{}`: {error}", path.display()))?;
    }
    let all = outcomes(&text);
    println!("{}", tally::page(kind, &all));
    Ok(all.iter().all(|outcome| tally::fault(kind, outcome).is_none()))
}

fn complete(
    kind: Kind,
    (from, to): (u64, u64),
    path: &std::path::Path,
) -> Result<(), Box<dyn std::error::Error>> {
    let ledger = Ledger::open(path).map_err(|error| format!("`{}`: {error}", path.display()))?;
    let known: BTreeSet<u64> = ledger.known.iter().map(|outcome| outcome.seed).collect();
    let missing: Vec<u64> = (from..to).filter(|seed| !known.contains(seed)).collect();
    let bar = ProgressBar::new(to.saturating_sub(from));
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} flights, {eta} left") {
        bar.set_style(style);
    }
    bar.set_position((to.saturating_sub(from)) - missing.len() as u64);
    let shared = Mutex::new((ledger, None));
    fly(kind, &missing, |outcome| {
        // A thread that panicked has written no half line: the ledger is as it was.
        let mut shared = shared.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        if let Err(error) = shared.0.add(&outcome) {
            shared.1 = Some(error);
        }
        bar.inc(1);
    });
    bar.finish_and_clear();
    let (_, failed) = shared.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    failed.map_or(Ok(()), |error| Err(format!("`{}`: {error}", path.display()).into()))
}
