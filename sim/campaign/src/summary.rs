//! The figures of a campaign: how often a run failed or was faulty, how each column is distributed, and the worst seeds.
//!
//! Invariant: depends on the rows alone, not on their order.

use crate::bounds::Rate;
use crate::campaign::{Campaign, Column, Replay, Type, Value, Worst};
use crate::error::Error;
use crate::file::{Header, Table};
use crate::row::Row;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Number of worst seeds, and of seeds for each fault, that are listed.
const LISTED: usize = 8;

/// Figures of a campaign.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// Name of the campaign.
    pub kind: String,
    /// Version of the scenario.
    pub version: u32,
    /// Options of the scenario.
    pub options: String,
    /// Hash of the models that this program has.
    pub models: String,
    /// Number of runs.
    pub runs: usize,
    /// Runs that are not as they must be: faulty, or without a result.
    pub bad: Rate,
    /// Each fault, and the reasons of runs without a result; the most frequent first.
    pub faults: Vec<Fault>,
    /// Each column.
    pub columns: Vec<Figures>,
    /// Remarks on the files.
    pub remarks: Vec<String>,
}

/// Fault of runs.
#[derive(Clone, Debug, Serialize)]
pub struct Fault {
    /// Description.
    pub what: String,
    /// Frequency.
    pub rate: Rate,
    /// The first seeds.
    pub seeds: Vec<Seed>,
}

/// A seed that is worth a look.
#[derive(Clone, Debug, Serialize)]
pub struct Seed {
    /// The seed.
    pub seed: u64,
    /// Its value, where a column is meant.
    pub value: Option<f64>,
    /// Command that shows its run.
    pub command: String,
    /// Page that shows its run.
    pub link: String,
}

/// Distribution of a column.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Figures {
    /// Name of the column.
    pub name: String,
    /// Unit of the numbers.
    pub unit: String,
    /// Meaning of the column.
    pub about: String,
    /// Number of finite numbers.
    pub finite: usize,
    /// Number of infinite ones.
    pub infinite: usize,
    /// Least finite number.
    pub least: Option<f64>,
    /// Median, the number at or below which half of the finite numbers are.
    pub median: Option<f64>,
    /// Number below which 90 % of them are.
    pub p90: Option<f64>,
    /// Number below which 99 % of them are.
    pub p99: Option<f64>,
    /// Greatest finite number.
    pub most: Option<f64>,
    /// Frequencies of texts and truths, the most frequent first.
    pub counts: Vec<(String, usize)>,
    /// The worst seeds, the worst first.
    pub worst: Vec<Seed>,
    /// The finite numbers, sorted.
    #[serde(skip)]
    pub sorted: Vec<f64>,
}

impl Summary {
    /// Computes the figures of rows.
    ///
    /// # Errors
    ///
    /// The campaign's names are not in order.
    pub fn of(campaign: &dyn Campaign, table: &Table) -> Result<Self, Error> {
        let header = Header::of(campaign)?;
        let mut faults: BTreeMap<String, Vec<u64>> = BTreeMap::new();
        for row in table.rows.values() {
            if let Some(what) = fault(campaign, row) {
                faults.entry(what).or_default().push(row.seed);
            }
        }
        let runs = table.rows.len() as u64;
        let bad = faults.values().map(|seeds| seeds.len() as u64).sum();
        let mut faults: Vec<Fault> = faults
            .into_iter()
            .map(|(what, seeds)| Fault {
                what,
                rate: Rate::of(seeds.len() as u64, runs),
                seeds: seeds.iter().take(LISTED).map(|it| seed(campaign, *it, None)).collect(),
            })
            .collect();
        faults.sort_by_key(|it| std::cmp::Reverse(it.rate.events));
        let columns = campaign.columns();
        let figures =
            columns.iter().enumerate().map(|(at, it)| Figures::of(campaign, table, at, it));
        Ok(Self {
            kind: header.kind,
            version: header.version,
            options: header.options,
            models: header.models,
            runs: table.rows.len(),
            bad: Rate::of(bad, runs),
            faults,
            columns: figures.collect(),
            remarks: table.remarks(),
        })
    }

    /// Formats the figures for a terminal, as Markdown.
    pub fn text(&self) -> String {
        let mut text = format!("{} runs of `{}`\n", self.runs, self.kind);
        let numbers: Vec<&Figures> = self.columns.iter().filter(|it| it.least.is_some()).collect();
        if !numbers.is_empty() {
            text +=
                "\n| figure | least | median | 90 % | 99 % | most |\n|:--|--:|--:|--:|--:|--:|\n";
        }
        for it in numbers {
            let cells =
                [it.least, it.median, it.p90, it.p99, it.most].map(|it| short(it.unwrap_or(0.0)));
            let _ = writeln!(text, "| {} | {} |", titled(it), cells.join(" | "));
        }
        let share = |it: &Rate| format!("{} of {} ({})", it.events, it.runs, bounds(it));
        for it in &self.faults {
            let seeds: Vec<String> = it.seeds.iter().map(|it| it.seed.to_string()).collect();
            let _ =
                writeln!(text, "\n{}: {}: seeds {}", share(&it.rate), it.what, seeds.join(", "));
        }
        let _ = writeln!(text, "\nnot as they must be: {}", share(&self.bad));
        for it in &self.remarks {
            let _ = writeln!(text, "\nremark: {it}");
        }
        text
    }
}

/// Formats the bounds of a probability, in per cent.
pub(crate) fn bounds(rate: &Rate) -> String {
    let of = |share: f64| short(100.0 * share);
    format!("{} to {} % with 95 % confidence", of(rate.low), of(rate.high))
}

/// Formats a number with four significant digits.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let digits = 3 - value.abs().log10().floor() as i32;
    if (-3..=7).contains(&digits) {
        let text = format!("{value:.*}", digits.max(0) as usize);
        let is_fraction = text.contains('.');
        if is_fraction { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{value:.3e}")
    }
}

/// Returns the name of a column with its unit.
pub(crate) fn titled(it: &Figures) -> String {
    let name = if it.about.is_empty() { &it.name } else { &it.about };
    if it.unit.is_empty() { name.clone() } else { format!("{name}, {}", it.unit) }
}

/// Returns the fault of a run.
pub fn fault(campaign: &dyn Campaign, row: &Row) -> Option<String> {
    match &row.result {
        Ok(values) => campaign.fault(values),
        Err(reason) => Some(format!("no result: {reason}")),
    }
}

fn seed(campaign: &dyn Campaign, seed: u64, value: Option<f64>) -> Seed {
    let Replay { command, link } = campaign.replay(seed);
    Seed { seed, value, command, link }
}

impl Figures {
    fn of(campaign: &dyn Campaign, table: &Table, at: usize, column: &Column) -> Self {
        let mut numbers: Vec<(f64, u64)> = Vec::new();
        let mut counts: BTreeMap<String, usize> = BTreeMap::new();
        let mut infinite = 0;
        for row in table.rows.values() {
            match row.result.as_ref().ok().and_then(|values| values.get(at)) {
                Some(Value::Number(number)) if number.is_finite() => {
                    numbers.push((*number, row.seed))
                }
                Some(Value::Number(_)) => infinite += 1,
                Some(Value::Text(text)) => *counts.entry(text.clone()).or_default() += 1,
                Some(Value::Truth(truth)) => *counts.entry(truth.to_string()).or_default() += 1,
                None => {}
            }
        }
        numbers.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        let mut worst: Vec<(f64, u64)> = match column.worst {
            Some(Worst::Largest) => numbers.iter().rev().take(LISTED).copied().collect(),
            Some(Worst::Smallest) => numbers.iter().take(LISTED).copied().collect(),
            None => Vec::new(),
        };
        worst.truncate(LISTED);
        let sorted: Vec<f64> = numbers.into_iter().map(|(number, _)| number).collect();
        let quantile = |share: f64| {
            let last = sorted.len().saturating_sub(1);
            sorted.get((share * last as f64).round() as usize).copied()
        };
        let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
        counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        Self {
            name: column.name.clone(),
            unit: column.unit.clone(),
            about: column.about.clone(),
            finite: sorted.len(),
            infinite,
            least: quantile(0.0),
            median: quantile(0.5),
            p90: quantile(0.9),
            p99: quantile(0.99),
            most: quantile(1.0),
            counts: if column.values == Type::Number { Vec::new() } else { counts },
            worst: worst.into_iter().map(|(value, at)| seed(campaign, at, Some(value))).collect(),
            sorted,
        }
    }
}
