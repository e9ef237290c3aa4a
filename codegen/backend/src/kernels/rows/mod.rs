//! Elimination by rows in vectors, for gcc and clang on x86-64: a solve or an inverse with 5 to 20 rows.
//!
//! The matrix is copied to rows of whole vectors. A step subtracts multiples of its pivot's row from every row below,
//! and finds the next pivot meanwhile. A solve processes its right-hand side along with the rows, so nothing of L is
//! kept. An inverse processes the identity along with the rows; its columns are in the order of the pivots, in the
//! lanes where the matrix has become zero, so each step uses whole rows and no lane is idle. Each element has
//! nalgebra's order: steps ascending, then back from the last.
//!
//! The omitted products, zeros of the identity times multipliers, are zero only if the multipliers are finite.
//! Otherwise the result shows it, and the variant of the other targets, in the same file, computes it again.
//!
//! Not for ARM, where exact arithmetic is the VFP's.

use std::fmt::Write as _;

use bessemer_ir::{Kernel, KernelRoutine};

use super::text::{bytes, fill, indented, values, vectors_if};
use super::{Buffer, Source, are_lent};

/// Smallest code size, bytes, for which it is used. The size counts the Cortex-A9's instructions; on x86-64, rows
/// take up to five times as much (bench/results/kernels.md).
pub(super) const BUDGET: u32 = 4 * 1024;

/// Largest size; for greater ones tiles need fewer memory accesses.
const LARGEST_SIZE: u32 = 20;

/// Returns true if every step is written out, since processors mispredict the ends of loops this short.
fn is_written_out(kernel: &Kernel) -> bool {
    kernel.dims[0] <= if kernel.routine == KernelRoutine::Inverse { 9 } else { 12 }
}

/// Vectors of x86-64, the widest first: macro and bytes.
const VECTORS: [(&str, u32); 3] = [("__AVX512F__", 64), ("__AVX__", 32), ("__SSE2__", 16)];

const ROW: &str = include_str!("row.c");
const SOLVE: &str = include_str!("solve.c");
const INVERSE: &str = include_str!("inverse.c");

/// Code that copies the matrix to rows: for the smallest and odd sizes, and for the others.
const GIVE: [&str; 2] = [include_str!("give_numbers.c"), include_str!("give_squares.c")];

/// Returns true if a kernel is faster by rows.
pub(super) fn fits(kernel: &Kernel) -> bool {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Solve, &[size, 1]) | (KernelRoutine::Inverse, &[size]) => {
            (5..=LARGEST_SIZE).contains(&size)
        }
        _ => false,
    }
}

/// Returns the stride of rows, in numbers.
fn pitch(size: u32) -> u32 {
    size.next_multiple_of(4)
}

/// Returns the usable targets: their macros, and the lanes of their vectors, of which rows are a multiple.
fn targets(kernel: &Kernel) -> impl Iterator<Item = (&'static str, u32)> {
    let (element, pitch) = (bytes(kernel.element), pitch(kernel.dims[0]));
    let lanes = move |(name, vector)| (name, vector / element);
    VECTORS.into_iter().map(lanes).filter(move |(_, lanes)| pitch.is_multiple_of(*lanes))
}

/// Returns the size of the rows in numbers, including the alignment to a vector.
pub(super) fn numbers(kernel: &Kernel) -> u32 {
    let widest = targets(kernel).map(|(_, lanes)| lanes).max().unwrap_or_default();
    let size = kernel.dims[0];
    size * pitch(size) + widest
}

/// Returns the size of the rows in local memory, bytes; on x86-64 some hundred.
pub(super) fn local_bytes(kernel: &Kernel) -> u64 {
    u64::from(numbers(kernel) * bytes(kernel.element))
}

/// Returns the kernel by rows, followed by the variant of the other targets.
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

/// Returns the `#if` for each target, with its lanes.
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

/// Returns the steps of the elimination; for small sizes each is written out with constant indices.
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

/// Returns the back substitution by U, from the last row upwards.
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
