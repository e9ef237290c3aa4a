//! The summary of a campaign: percentiles, and the number of faulty flights.

use super::Kind;
use super::outcome::Outcome;
use bessemer_campaign::{Row, Table};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Fastest permitted touch-down of a flight without failures, m/s.
const SOFT: f64 = 0.5;

/// Returns the fault of a flight.
pub fn fault(kind: Kind, outcome: &Outcome) -> Option<&'static str> {
    match kind {
        Kind::Spread if outcome.left.is_finite() => Some("left the envelope"),
        Kind::Spread if outcome.stopped.is_finite() => Some("stopped by the crash predictor"),
        Kind::Spread if outcome.impact > SOFT => Some("hit the ground above 0.5 m/s"),
        Kind::Spread if !outcome.well => Some("did not end on the ground, motors off"),
        Kind::Failures if outcome.stopped_for_nothing() => Some("stopped for nothing"),
        Kind::Failures if outcome.missed() => Some("missed: left the envelope, motors on"),
        _ => None,
    }
}

/// Returns the fault of a flight, or the reason why it has no result.
pub fn verdict(kind: Kind, row: &Row) -> Option<String> {
    bessemer_campaign::summary::fault(&kind, row)
}

/// Formats a Markdown page about a campaign.
pub fn page(kind: Kind, table: &Table) -> String {
    let mut outcomes = Vec::with_capacity(table.rows.len());
    let mut faults: BTreeMap<String, Vec<u64>> = BTreeMap::new();
    for row in table.rows.values() {
        outcomes.extend(row.result.as_ref().ok().and_then(|it| Outcome::of(row.seed, it)));
        if let Some(fault) = verdict(kind, row) {
            faults.entry(fault).or_default().push(row.seed);
        }
    }
    let mut text = String::new();
    let _ = writeln!(text, "{} flights\n", table.rows.len());
    text.push_str(&match kind {
        Kind::Spread => spread(&outcomes),
        Kind::Failures => failures(&outcomes),
    });
    if faults.is_empty() {
        let _ = writeln!(text, "\nnone was as it must not be");
    }
    for (fault, seeds) in faults {
        let some: Vec<String> = seeds.iter().take(8).map(u64::to_string).collect();
        let _ = writeln!(text, "\n{}: {fault}: seeds {}", seeds.len(), some.join(", "));
    }
    text
}

fn spread(outcomes: &[Outcome]) -> String {
    let mut text =
        String::from("| figure | median | 90 % | 99 % | worst |\n|:--|--:|--:|--:|--:|\n");
    let mut row = |name: &str, of: fn(&Outcome) -> f64| {
        let values = sorted(outcomes.iter().map(of));
        let at = |share| cell(&values, share, 3);
        let _ =
            writeln!(text, "| {name} | {} | {} | {} | {} |", at(0.5), at(0.9), at(0.99), at(1.0));
    };
    row("error of height once settled, m", |outcome| outcome.height);
    row("distance in the plane once settled, m", |outcome| outcome.place);
    row("touch-down, m/s", |outcome| outcome.impact);
    text
}

fn failures(outcomes: &[Outcome]) -> String {
    let mut groups: BTreeMap<&str, Vec<&Outcome>> = BTreeMap::new();
    for outcome in outcomes {
        groups.entry(&outcome.failure).or_default().push(outcome);
    }
    let mut text = String::from(
        "| failure | flights | stopped | flown on | s to stop, median | s from stop to leaving, median | longest |\n\
         |:--|--:|--:|--:|--:|--:|--:|\n",
    );
    for (failure, group) in groups {
        let stopped: Vec<_> = group.iter().filter(|outcome| outcome.stopped.is_finite()).collect();
        let reaction = sorted(stopped.iter().map(|outcome| outcome.stopped - outcome.broke));
        let ahead = sorted(stopped.iter().map(|outcome| outcome.left - outcome.stopped));
        let _ = writeln!(
            text,
            "| {failure} | {} | {} | {} | {} | {} | {} |",
            group.len(),
            stopped.len(),
            group.len() - stopped.len(),
            cell(&reaction, 0.5, 2),
            cell(&ahead, 0.5, 2),
            cell(&ahead, 1.0, 2)
        );
    }
    text
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut all: Vec<f64> = values.collect();
    all.sort_by(f64::total_cmp);
    all
}

/// Formats the value below which a fraction `share` of the sorted values are, with `decimals` decimals; a dash if
/// there are none.
fn cell(sorted: &[f64], share: f64, decimals: usize) -> String {
    let last = sorted.len().saturating_sub(1);
    let value = sorted.get((share * last as f64).round() as usize);
    value.map_or_else(|| "–".to_owned(), |value| format!("{value:.decimals$}"))
}
