//! A large solve for one right-hand side whose rows stay where they are: on x86-64 with AVX.
//!
//! An order says which row each pivot took, so that nothing on the left of a panel is exchanged; multipliers are read
//! from all rows of a tile at once. A panel is factored by columns: each loses those on its left when its turn comes, and gives
//! the largest of its magnitudes, the next pivot, on the way. The right-hand side is a column more.
//!
//! The order of each element is that of the tiles, and what stands in the same file for the other targets.
//!
//! Absent: SSE2, with which it takes the same time as tiles; AVX-512; ARM; inverses, and solves that give factors back.

use std::fmt::Write as _;

use bessemer_ir::{Kernel, KernelRoutine};

use super::lanes;
use crate::kernels::Mode;
use crate::kernels::text::{bytes, fill};

/// Its functions.
pub(super) const TEXT: &str = include_str!("elimination.c");
const TILE: &str = include_str!("tile.c");
/// The body of the kernel.
pub(super) const BODY: &str = include_str!("body.c");

/// What the last columns need where they are no four.
pub(super) const PART: &str = "\
        /* Columns at the end that are no four. */
        for (; columns % 4U != 0U; columns--) {
            const uint32_t column = first + columns - 1U;
            for (uint32_t row = 0U; row < first; row++) {
                x[row] -= *at(work, row, column) * x[column];
            }
        }
";

/// The fewest panels for which it pays: below, what it does beside the tiles takes longer than exchanges did.
const PANELS: u32 = 8;

/// Rows of the tallest tile.
const TALLEST: u32 = 6;

/// Rows of a tile. Of six, twelve sums hide that a fused step waits longer for the last one's; otherwise they take as long as
/// four, which need no rows beyond the last.
const fn tall(mode: Mode) -> u32 {
    match mode {
        Mode::Exact => 4,
        Mode::Fast => TALLEST,
    }
}

/// Columns of a panel: two vectors.
fn width(kernel: &Kernel) -> u32 {
    2 * lanes::ORDERED / bytes(kernel.element)
}

/// Whether a kernel has this form.
pub(super) fn fits(kernel: &Kernel) -> bool {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Solve, &[size, 1]) => size >= PANELS * width(kernel),
        _ => false,
    }
}

/// Numbers of the panel, of the block and of the right-hand side.
pub(super) fn numbers(kernel: &Kernel) -> u32 {
    let (rows, width) = (super::rows(kernel.dims[0]), width(kernel));
    let group = 2 * width;
    width * rows.next_multiple_of(TALLEST) + width * rows.next_multiple_of(group) + rows + group
}

/// Numbers of the two orders of the rows.
pub(super) fn orders(size: u32) -> u32 {
    super::rows(size).next_multiple_of(TALLEST) + super::rows(size)
}

/// The tile: its rows, one after another, and what happens to each.
pub(super) fn tile(mode: Mode) -> String {
    let tall = tall(mode);
    let rows = || "abcdef".chars().take(tall as usize);
    let each = |line: &dyn Fn(usize, char) -> String| -> String {
        rows().enumerate().map(|(at, row)| line(at, row)).collect()
    };
    let plus = |k: usize| if k == 0 { String::new() } else { format!(" + {k}U") };
    let beyond = |k: usize| if k == 0 { "0U".to_owned() } else { format!("{k}U * WIDTH") };
    let mut own = String::new();
    for (k, row) in rows().enumerate() {
        // Writing to a string cannot fail.
        let _ = writeln!(own, "    if (steps > {k}U) {{");
        for below in rows().skip(k + 1) {
            let _ = writeln!(
                own,
                "        tile->{below} = minus(tile->{below}, of->{below}[column{}], tile->{row});",
                plus(k)
            );
        }
        let _ = writeln!(own, "        store_row(&of->{row}[from], tile->{row});\n    }}");
    }
    // Tiles begin at multiples of this, and so do panels.
    let unrolled = if tall.is_multiple_of(4) { 4 } else { 2 };
    let steps = (0..unrolled)
        .map(|k| format!("        step(&tile, &of, column{}, &upper[{}]);\n", plus(k), beyond(k)));
    let values = [
        ("steps", steps.collect()),
        ("unrolled", format!("{unrolled}U")),
        ("tall", format!("{tall}U")),
        ("rows", each(&|_, row| format!("    row_t {row};\n"))),
        ("places", each(&|_, row| format!("    $real *{row};\n"))),
        ("load", each(&|at, row| format!("    tile.{row} = load_row(&from[{}]);\n", beyond(at)))),
        ("store", each(&|at, row| format!("    store_row(&to[{}], tile->{row});\n", beyond(at)))),
        ("find", each(&|at, row| format!("    of.{row} = at(work, row{}, 0U);\n", plus(at)))),
        (
            "minus",
            each(&|_, row| {
                format!("    tile->{row} = minus(tile->{row}, of->{row}[column], other);\n")
            }),
        ),
        ("hold", each(&|_, row| format!("    IN_REGISTERS(tile->{row});\n"))),
        ("own", own),
    ];
    fill(TILE, &values)
}
