//! List of cases in which the generated C is slower than its limit relative to the best of the others.
//!
//! The report lists every such case of a run, with the reason that somebody found for it. A case without a reason is one that somebody
//! has to look at.
//!
//! This module must not know why a case exceeds its limit: the reasons are in `reasons`.

use std::fmt::Write as _;

use super::case::{Case, Routine};
use super::contender::Contender;
use super::reasons::{Place, Reasons};
use super::report::ratio;
use super::results::{Cell, Results, Row, Table};

/// Size from which the limit is below the best of the others.
const AIMS: usize = 6;

/// The limit of a case, as a fraction of the best of the others.
fn limit(case: &Case, counted: bool) -> f64 {
    match (case.size >= AIMS && counted, case.routine) {
        (false, _) => 1.0,
        (true, Routine::Product) => 0.9,
        (true, _) => 0.6,
    }
}

fn is_counted(table: &Table) -> bool {
    table.rows.iter().flat_map(|row| &row.cells).flatten().all(|cell| cell.times.is_none())
}

/// The contender that the generated C is compared with.
fn best(table: &Table, row: &Row) -> Option<Contender> {
    // The larger ratio is the shorter time, the smaller count the fewer instructions: both as a cost.
    let cost = |cell: &Cell| match (cell.times, cell.instructions) {
        (Some(times), _) => -times.ratio,
        (None, count) => count.unwrap_or_default() as f64,
    };
    let others = table.contenders.iter().zip(&row.cells).skip(1);
    let costs = others.filter_map(|(contender, cell)| Some((*contender, cost(cell.as_ref()?))));
    costs.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(contender, _)| contender)
}

/// A case above its limit.
struct Above<'a> {
    table: &'a Table,
    case: &'a Case,
    ratio: f64,
    limit: f64,
    best: Contender,
}

impl Above<'_> {
    fn place(&self) -> Place {
        Place {
            machine: self.table.machine.name.to_owned(),
            case: self.case.name(),
            best: self.best.name().to_owned(),
        }
    }
}

fn above(results: &Results) -> Vec<Above<'_>> {
    let mut list = Vec::new();
    for table in &results.small {
        let counted = is_counted(table);
        for row in &table.rows {
            let (Some(ratio), Some(best)) = (ratio(row), best(table, row)) else { continue };
            let (case, limit) = (&row.case, limit(&row.case, counted));
            // What the table shows as the limit is at it.
            if ratio >= limit + 0.005 {
                list.push(Above { table, case, ratio, limit, best });
            }
        }
    }
    list
}

/// Returns the number of cases above their limit without a reason.
pub fn without_reason(results: &Results, reasons: &Reasons) -> usize {
    above(results).iter().filter(|it| reasons.of_case(&it.place()).is_none()).count()
}

/// A line for each case that is above its limit and is not listed, or is listed and is not above it.
pub fn unsettled(results: &Results, reasons: &Reasons) -> Vec<String> {
    let found: Vec<Place> = above(results).iter().map(Above::place).collect();
    let unknown = found.iter().filter(|place| !reasons.cases().any(|known| known == *place));
    let unknown = unknown.map(|place| format!("{place}: above its limit, and not listed"));
    let settled = reasons.cases().filter(|place| !found.contains(place));
    let settled = settled.map(|place| format!("{place}: listed, and not above its limit"));
    unknown.chain(settled).collect()
}

/// A line for each case above its limit.
pub fn markdown(results: &Results, reasons: &Reasons) -> String {
    let mut lines = String::new();
    for it in above(results) {
        let _ = writeln!(
            lines,
            "| {} | {} {} {} | {:.2} | {:.1} | {} | {} |",
            it.table.machine.title,
            it.case.routine.title(),
            it.case.element.name(),
            it.case.size,
            it.ratio,
            it.limit,
            it.best.title(),
            reasons.of_case(&it.place()).unwrap_or("no reason known"),
        );
    }
    if lines.is_empty() {
        return String::new();
    }
    format!(
        "\n### Above the best\n\nOf instructions, what takes more than the best of the others, or from six rows on more than 0.9 of it (products) \
         or 0.6 (all else); of time, what takes more than the best.\n\n\
         | machine | case | ratio | limit | best | why |\n|---|---|---:|---:|---|---|\n{lines}"
    )
}
