//! A large solve for one right-hand side whose rows stay where they are: on x86-64 with AVX.
//!
//! An order says which row each pivot took, so that nothing on the left of a panel is exchanged; multipliers are read
//! from four rows at once. A panel is factored by columns: each loses those on its left when its turn comes, and gives
//! the largest of its magnitudes, the next pivot, on the way. The right-hand side is a column more.
//!
//! The order of each element is that of the tiles, and what stands in the same file for the other targets.
//!
//! Absent: SSE2, with which it takes the same time as tiles; AVX-512; ARM; inverses, and solves that give factors back.

use bessemer_ir::{Kernel, KernelRoutine};

use super::{lanes, lu};
use crate::kernels::text::bytes;

/// Its functions.
pub(super) const TEXT: &str = include_str!("ordered.c");
/// The body of the kernel.
pub(super) const BODY: &str = include_str!("ordered_body.c");

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
    let (rows, width) = (lu::rows(kernel.dims[0]), width(kernel));
    let group = 2 * width;
    width * rows + width * rows.next_multiple_of(group) + rows + group
}
