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
    let machine = table.machine.name;
    match (is_counted(table), machine) {
        (true, "host-sse2" | "host-avx2") => counted_on_host(machine, case, best),
        (true, _) => counted_on_target(machine, case, best),
        (false, "host-scalar") => timed_without_vectors(case, best),
        (false, _) => timed(case, best),
    }
}

const LOOK: &str = "the look for a determinant of zero, nalgebra's `None`: four instructions on x86-64, three on ARM; Eigen has none, \
                    and divides once";
const MINORS: &str = "240 operations for nalgebra's sums of six products; Eigen's cofactors share 2×2 minors and take half";
const EIGHT: &str = "as many operations as numbers, since a matrix often has just been stored by a product: with eight elements in a vector it takes 0.7 of \
                     Eigen's time where the matrix has lain for long, and 1.2 of its own behind a product, which stores by twos";
const DIVISIONS: &str = "the look for a determinant of zero, and a division for each element, as nalgebra's: a cycle that is gone without them; \
                         Eigen has none, and divides once";
const NEON: &str = "NEON: Eigen's flushes subnormals; exact `f32` stays on the VFP";

fn counted_on_host(machine: &str, case: &Case, best: Contender) -> Option<&'static str> {
    let eigen = best == Contender::Eigen;
    match (case.routine, case.size) {
        (Routine::Inverse, 2 | 3) => Some(LOOK),
        (Routine::Inverse, 4) if eigen => Some(MINORS),
        (Routine::Product, 2) => Some(
            "stands where it is used, as numbers, which gcc puts into vectors: numbers of the right factor spread by shuffles of integers take two \
             instructions less, and 1.5 times as long",
        ),
        (Routine::Product, ..6) if machine == "host-avx2" && eigen => Some(
            "FMA: Eigen fuses by intrinsics whatever the flags say; the bits need each product rounded",
        ),
        (Routine::Product, AIMS..) if machine == "host-avx2" => Some(
            "16 registers: 2.67 instructions for each vector and term; a column at a time takes fewer, and 1.2 to 1.7 times as long; for 14 rows \
             ours takes 0.65 of the best's time",
        ),
        (Routine::Product, AIMS..) => Some(
            "two operands: load, multiply, add for each vector and term, and the odd row has a vector of its own",
        ),
        _ => None,
    }
}

fn counted_on_target(machine: &str, case: &Case, best: Contender) -> Option<&'static str> {
    let eigen = best == Contender::Eigen;
    match (case.routine, case.element, case.size) {
        (Routine::Inverse, Element::F64, 2) => Some(LOOK),
        (Routine::Inverse, Element::F32, 2) if machine == "a9" => Some(
            "the look for `None` takes three, by which it is above; four go to a vector that gcc gathers on the stack (-fno-tree-slp-vectorize)",
        ),
        (Routine::Inverse, Element::F32, 2) => Some(LOOK),
        (_, Element::F32, _) if machine == "a9" && eigen => Some(NEON),
        (Routine::CholeskySolve, _, 2) => Some(
            "the looks at two roots for nalgebra's `None` take six; the best takes roots of anything",
        ),
        _ => None,
    }
}

fn timed(case: &Case, best: Contender) -> Option<&'static str> {
    match (case.routine, case.size) {
        (Routine::Inverse, 3) if case.element == Element::F64 => Some(EIGHT),
        (Routine::Inverse, 2) if best == Contender::Eigen => Some(DIVISIONS),
        (Routine::CholeskySolve, 3 | 4) => Some(
            "nalgebra sums a row of the substitution backwards from zero, then subtracts it: naive C in that order takes 1.02 to 1.06 of its \
             time",
        ),
        (Routine::CholeskySolve, 2) => {
            Some("as many instructions as the best or fewer: within what runs differ by")
        }
        (Routine::Product, 4) => Some(
            "one call beside the other: naive C's vectors of 64 bytes hold two columns; where a product is a factor of the next, ours takes 0.7 of it",
        ),
        (Routine::Product, 2 | 3) => {
            Some("as many instructions as the best or fewer: within what runs differ by")
        }
        _ => None,
    }
}

fn timed_without_vectors(case: &Case, best: Contender) -> Option<&'static str> {
    match (case.routine, case.size) {
        (Routine::Inverse, 2 | 3) if best == Contender::Eigen => {
            Some("a division for each element, as nalgebra's; Eigen divides once and multiplies")
        }
        (Routine::CholeskySolve, 10..) => Some(
            "tiles of sixteen numbers for ARM's 32 registers; with 16, a fifth of the instructions on numbers go through the stack (75 of 371 for 15 \
             rows)",
        ),
        (Routine::LuSolve, 20) => Some(
            "tiles of sixteen numbers for ARM's 32 registers; with 16 they go through the stack; up to 19 rows it is written out, and takes less than \
             any other",
        ),
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

/// A case above its limit.
struct Above<'a> {
    table: &'a Table,
    case: &'a Case,
    ratio: f64,
    limit: f64,
    best: Contender,
    why: Option<&'static str>,
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
                let why = reason(table, case, best);
                list.push(Above { table, case, ratio, limit, best, why });
            }
        }
    }
    list
}

/// How many cases above their limit have no reason.
pub fn without_reason(results: &Results) -> usize {
    above(results).iter().filter(|it| it.why.is_none()).count()
}

/// A line for each case above its limit.
pub fn markdown(results: &Results) -> String {
    let mut lines = String::new();
    for Above { table, case, ratio, limit, best, why } in above(results) {
        let _ = writeln!(
            lines,
            "| {} | {} {} {} | {ratio:.2} | {limit:.1} | {} | {} |",
            table.machine.title,
            case.routine.title(),
            case.element.name(),
            case.size,
            best.title(),
            why.unwrap_or("no reason known"),
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
