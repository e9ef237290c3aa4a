//! Where the generated C takes more than it should beside the best of the others, and why.
//!
//! The report lists every such case of a run, with its reason from the small table here, so that no document has
//! to be kept. A case without a reason is one that somebody has to look at.

use std::fmt::Write as _;

use super::case::{Case, Element, Routine};
use super::contender::Contender;
use super::report::ratio;
use super::results::{Cell, Results, Row, Table};

/// From this size on the generated C aims at less than the best.
const AIMS: usize = 6;

/// The largest share of the best's figure that a case is to take.
fn limit(case: &Case, counted: bool) -> f64 {
    match (case.size >= AIMS && counted, case.routine) {
        (false, _) => 1.0,
        (true, Routine::Product) => 0.9,
        (true, _) => 0.6,
    }
}

/// Why a case is above its limit.
fn reason(table: &Table, case: &Case, best: Contender) -> Option<&'static str> {
    let (machine, counted) = (table.machine.name, is_counted(table));
    let eigen = best == Contender::Eigen;
    match (case.routine, case.element, case.size) {
        (_, Element::F32, _) if machine == "a9" && eigen => {
            Some("NEON: Eigen's flushes subnormals; exact `f32` stays on the VFP")
        }
        (Routine::LuSolve, Element::F32, 19) if machine == "a9" => {
            Some("the way back is loops: written out it takes more than 8 KiB")
        }
        (Routine::Product, ..) if machine == "host-avx2" && eigen => Some(
            "FMA: Eigen fuses by intrinsics whatever the flags say; the bits need each product rounded",
        ),
        (Routine::CholeskySolve, Element::F32, 8) if machine == "host-avx2" => Some(
            "up to nine rows the factor is written out number by number; from ten on it has vectors",
        ),
        (Routine::Inverse, _, 2 | 3) => Some(
            "the look for a determinant of zero, nalgebra's `None`; Eigen has none, and divides once",
        ),
        (Routine::CholeskySolve, _, 2) => {
            Some("the look at each root for nalgebra's `None`; the best takes roots of anything")
        }
        (Routine::Inverse, _, 4) if eigen => Some(
            "Eigen's cofactors are products of 2×2 minors, with half the multiplications; the bits need nalgebra's",
        ),
        (Routine::Product, _, AIMS..) if counted && machine == "host-avx2" => Some(
            "16 registers: 2.67 instructions for each vector and term; a column at a time takes fewer, and 1.2 to 1.7 times as long",
        ),
        (Routine::Product, _, AIMS..) if counted && machine == "host-sse2" => {
            Some("16 registers of two-operand instructions: copies and loads are a third of all")
        }
        _ => None,
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

/// A line for each case above its limit.
pub fn markdown(results: &Results) -> String {
    let mut lines = String::new();
    for table in &results.small {
        let counted = is_counted(table);
        for row in &table.rows {
            let (Some(ratio), Some(best)) = (ratio(row), best(table, row)) else { continue };
            let limit = limit(&row.case, counted);
            // What the table shows as the limit is at it.
            if ratio < limit + 0.005 {
                continue;
            }
            let why = reason(table, &row.case, best).unwrap_or("no reason known");
            let _ = writeln!(
                lines,
                "| {} | {} {} {} | {ratio:.2} | {limit:.1} | {} | {why} |",
                table.machine.title,
                row.case.routine.title(),
                row.case.element.name(),
                row.case.size,
                best.title(),
            );
        }
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
