//! Elimination by rows in vectors, where gcc or clang have them: a solve or an inverse of 5 to 20 rows on x86-64.
//!
//! The matrix is brought into rows of whole vectors. A step takes the row of its pivot times a multiplier from every
//! row below it, and looks for the next pivot on the way. A solve carries its right-hand side along, so that nothing of
//! L is kept. An inverse carries the identity along, its columns in the order of the pivots, in the lanes where the
//! matrix has become zero: each step is whole rows, and no lane is idle. The order of each element is nalgebra's: steps
//! ascending, then back from the last.
//!
//! The products that are left out, zeros of the identity times multipliers, are zero only if the multipliers are finite. One that is
//! not leaves its trace in the result; then the form of the other targets, which is in the same file, does it again.
//!
//! Absent: ARM, where exact arithmetic is the VFP's.

use std::fmt::Write as _;

use bessemer_ir::{Kernel, KernelRoutine};

use super::text::{bytes, fill, indented, values, vectors_if};
use super::{Buffer, Source, are_lent};

/// The smallest budget of code with which it is used. The budget is the Cortex-A9's; on x86-64 rows take up to five
/// times as much (bench/results/kernels.md).
pub(super) const BUDGET: u32 = 4 * 1024;

/// From here on tiles take fewer steps from memory to memory.
const LARGEST_SIZE: u32 = 20;

/// Up to this size every step is written out: a processor guesses wrongly when loops as short as these end.
fn is_written_out(kernel: &Kernel) -> bool {
    kernel.dims[0] <= if kernel.routine == KernelRoutine::Inverse { 9 } else { 12 }
}

/// The vectors of x86-64, the widest first: the macro that says that they are there, and their bytes.
const VECTORS: [(&str, u32); 3] = [("__AVX512F__", 64), ("__AVX__", 32), ("__SSE2__", 16)];

const ROW: &str = include_str!("row.c");
const SOLVE: &str = include_str!("solve.c");
const INVERSE: &str = include_str!("inverse.c");

/// The smallest and odd ones, and the others.
const GIVE: [&str; 2] = [include_str!("give_numbers.c"), include_str!("give_squares.c")];

/// Returns true if a kernel gains by it.
pub(super) fn fits(kernel: &Kernel) -> bool {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Solve, &[size, 1]) | (KernelRoutine::Inverse, &[size]) => {
            (5..=LARGEST_SIZE).contains(&size)
        }
        _ => false,
    }
}

/// Numbers from a row to the next.
fn pitch(size: u32) -> u32 {
    size.next_multiple_of(4)
}

/// The targets: their macros, and numbers in a vector that rows are whole ones of.
fn targets(kernel: &Kernel) -> impl Iterator<Item = (&'static str, u32)> {
    let (element, pitch) = (bytes(kernel.element), pitch(kernel.dims[0]));
    let lanes = move |(name, vector)| (name, vector / element);
    VECTORS.into_iter().map(lanes).filter(move |(_, lanes)| pitch.is_multiple_of(*lanes))
}

/// Numbers that the rows take, with what it takes to begin at a vector.
pub(super) fn numbers(kernel: &Kernel) -> u32 {
    let widest = targets(kernel).map(|(_, lanes)| lanes).max().unwrap_or_default();
    let size = kernel.dims[0];
    size * pitch(size) + widest
}

/// Bytes of the rows where no memory is lent: on x86-64, some hundred.
pub(super) fn local_bytes(kernel: &Kernel) -> u64 {
    u64::from(numbers(kernel) * bytes(kernel.element))
}

/// The kernel of the other targets, and this one before it.
pub(super) fn source(kernel: &Kernel, other: Source, buffers: &[Buffer]) -> Source {
    let own = match kernel.routine {
        KernelRoutine::Inverse => ROW.to_owned() + "\n" + INVERSE,
        _ => ROW.to_owned() + "\n" + SOLVE,
    };
    let own = fill(&fill(&own, &all_values(kernel)), &all_values(kernel));
    let rows = rows(kernel, buffers);
    let (before, body) = match kernel.routine {
        KernelRoutine::Inverse => {
            let before =
                format!("{}\n\n{}\n#if defined(LANES)\n{own}#endif", other.before, choice(kernel));
            (
                before,
                format!(
                    "#if defined(LANES)\n{{\n{}}}\n#endif\n{}",
                    indented(&(rows + INVERT)),
                    other.body
                ),
            )
        }
        _ => {
            let before = format!(
                "{}\n#if defined(LANES)\n{own}#else\n{}\n#endif",
                choice(kernel),
                other.before
            );
            (
                before,
                format!(
                    "#if defined(LANES)\n{rows}{}#else\n{}#endif\n",
                    spoiling(kernel),
                    other.body
                ),
            )
        }
    };
    Source { before, body, ..other }
}

const INVERT: &str = "\
bool finite = true;
const bool regular = invert_by_rows(a, rows, &finite);
if (!regular || finite) {
    return regular;
}
/* A multiplier was not finite: once more, with every zero. */
";

fn spoiling(kernel: &Kernel) -> String {
    const TEXT: &str = "\
if (!solve_by_rows(a, b, rows)) {
    for (uint32_t index = 0U; index < $n; index++) {
        b[index] = $nan;
    }
    return false;
}
return true;
";
    fill(TEXT, &all_values(kernel))
}

/// Returns the place of the rows: the passed memory, or a local.
fn rows(kernel: &Kernel, buffers: &[Buffer]) -> String {
    let place = match are_lent(buffers) {
        true => format!("$real *const rows = first_vector(work->{});\n", buffers[0].name),
        false => format!(
            "$real memory[{}];\n$real *const rows = first_vector(memory);\n",
            numbers(kernel)
        ),
    };
    fill(&place, &all_values(kernel))
}

/// `#if` for each target, and its lanes.
fn choice(kernel: &Kernel) -> String {
    let mut text = String::new();
    for (index, (name, lanes)) in targets(kernel).enumerate() {
        let word = if index == 0 { "if" } else { "elif" };
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "#{word} {}\n#define LANES {lanes}U\n#define SIDE {}U",
            vectors_if(&format!("defined({name})")),
            lanes.min(4)
        );
    }
    text + "#endif\n"
}

fn all_values(kernel: &Kernel) -> Vec<(&'static str, String)> {
    let size = kernel.dims[0];
    let mut all = values(kernel.element, &[("n", size), ("pitch", pitch(size))]);
    let whole = bytes(kernel.element);
    let (first, filled) = match kernel.routine {
        KernelRoutine::Inverse => ("0U".to_owned(), "LANES * (PARTS - 1U)".to_owned()),
        // To the right, so that the vectors that are done with drop out early.
        _ => (format!("(LANES * PARTS - {size}U)"), "0U".to_owned()),
    };
    let unroll = format!("#pragma GCC unroll {}\n", if is_written_out(kernel) { 16 } else { 2 });
    let kept = vec!["-1"; pitch(size) as usize].join(", ");
    all.extend([
        ("bytes", format!("{whole}U")),
        ("word", format!("int{}_t", 8 * whole)),
        ("first", first),
        ("filled", filled),
        ("kept", kept),
        ("give", GIVE[usize::from(size >= 8)].to_owned()),
        ("unroll", unroll),
        ("steps", steps(kernel)),
        ("upwards", upwards(kernel)),
    ]);
    all
}

/// The steps of the elimination; small ones know where they are, so that their loops are written out.
fn steps(kernel: &Kernel) -> String {
    let size = kernel.dims[0];
    let with = if kernel.routine == KernelRoutine::Inverse { "order" } else { "b" };
    let step = |k: &str| {
        format!(
            "if (pivot.magnitude == $zero) {{\n    return false;\n}}\npivot = eliminate_by(rows, {with}, {k}, pivot);\n"
        )
    };
    let text: String = match kernel.routine == KernelRoutine::Inverse && !is_written_out(kernel) {
        true => format!("for (uint32_t k = 0U; k + 1U < $n; k++) {{\n{}}}\n", indented(&step("k"))),
        false => (0..size - 1).map(|k| step(&format!("{k}U"))).collect(),
    };
    indented(&text)
}

/// Back by U, from the last row upwards.
fn upwards(kernel: &Kernel) -> String {
    let size = kernel.dims[0];
    let mut text = String::new();
    if kernel.routine == KernelRoutine::Inverse {
        match !is_written_out(kernel) {
            true => {
                text += "for (uint32_t below = $n; below > 0U; below--) {\n    substitute_row(rows, below - 1U, sums);\n}\n"
            }
            false => {
                for row in (0..size).rev() {
                    let _ = writeln!(text, "substitute_row(rows, {row}U, sums);");
                }
            }
        }
        return indented(&text);
    }
    text += "const $real *const u = &rows[FIRST];\n";
    let pitch = pitch(size);
    for row in (0..size).rev() {
        let _ = writeln!(text, "$real x{row} = b[{row}];");
        for k in (row + 1..size).rev() {
            let _ = writeln!(text, "x{row} -= u[{}] * x{k};", pitch * row + k);
        }
        let _ = writeln!(text, "x{row} /= u[{}];\nb[{row}] = x{row};", (pitch + 1) * row);
    }
    indented(&text)
}
