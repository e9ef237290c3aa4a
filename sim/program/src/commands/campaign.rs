//! `cargo xtask campaign`: flies very many flights on all cores, and summarises their results.

use super::Outcome;
use indicatif::{ProgressBar, ProgressStyle};
use sim::campaign::ledger::{Ledger, outcomes};
use sim::campaign::{Kind, fly, tally};
use sim_args::{Campaign, Subject};
use std::collections::BTreeSet;
use std::sync::Mutex;

/// Flies the missing flights, and prints a summary of all.
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
