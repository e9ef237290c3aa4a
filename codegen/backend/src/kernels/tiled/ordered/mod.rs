//! Large solves and inverses whose rows stay where they are: on x86-64 with AVX.
//!
//! An order says which row each pivot took, so that nothing on the left of a panel is exchanged; multipliers are read
//! from all rows of a tile at once. A panel is factored by columns: each loses those on its left when its turn comes, and gives
//! the largest of its magnitudes, the next pivot, on the way. A single right-hand side is a column more; those of
//! an inverse go through panels of their own, two at a time, whose divisions by U's diagonal wait side by side.
//!
//! The order of each element is that of the tiles, and what is in the same file for the other targets.
//!
//! Absent: SSE2, with which it takes the same time as tiles; AVX-512; ARM; several right-hand sides, and solves that give
//! factors back.

use bessemer_ir::{Float, Kernel, KernelRoutine};

use super::lanes;
use crate::kernels::Mode;
use crate::kernels::text::{bytes, decided};
use crate::kernels::threads::{Own, Work};

const ELIMINATION: &str = include_str!("elimination.c");
const TILE: &str = include_str!("tile.c");
const SUBSTITUTE: &str = include_str!("substitute.c");
const INVERT: &str = include_str!("invert.c");
const SOLVE: &str = include_str!("solve.c");
const INVERSE: &str = include_str!("inverse.c");

/// The fewest bytes of a row with which it pays: below, what it does beside the tiles takes longer than exchanges did.
const SMALLEST: u32 = 512;

/// Returns true if a kernel has this form.
pub(super) fn fits(kernel: &Kernel) -> bool {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Solve, &[size, 1]) | (KernelRoutine::Inverse, &[size]) => {
            size >= SMALLEST / bytes(kernel.element)
        }
        _ => false,
    }
}

/// Numbers of the panel, and of what is beside it.
pub(super) fn numbers(kernel: &Kernel) -> u32 {
    let (rows, width) = (super::rows(kernel.dims[0]), lanes::ordered_width(kernel.element));
    let group = lanes::ordered_group(kernel.element);
    let factoring = width * rows + width * rows.next_multiple_of(group);
    match kernel.routine {
        // A right-hand side.
        KernelRoutine::Solve => factoring + rows + group,
        // Two panels of right-hand sides, and a tile of zeros.
        _ => factoring.max(2 * width * rows + 4 * width),
    }
}

/// Numbers of the two orders of the rows.
pub(super) fn orders(size: u32) -> u32 {
    2 * super::rows(size)
}

/// Returns the code before the kernel; `own` is the private memory of an inverse's thread.
pub(super) fn text(kernel: &Kernel, mode: Mode, own: Own<'static>) -> String {
    let solve = kernel.routine == KernelRoutine::Solve;
    let all = decided(
        &ELIMINATION.replace("$tile\n", &decided(TILE, "TWO_QUADS", kernel.element == Float::F32)),
        "SIDE",
        solve,
    );
    let rest = match solve {
        true => SUBSTITUTE.to_owned(),
        false => format!("{INVERT}\n{}", work(own).text()),
    };
    let over = if mode == Mode::Fast { "*" } else { "/" };
    completed(&format!("{all}\n{rest}").replace("$over", over), kernel, mode)
}

/// The body of the kernel.
pub(super) fn body(kernel: &Kernel, mode: Mode, own: Own<'static>) -> String {
    let body = match kernel.routine {
        KernelRoutine::Solve => SOLVE.to_owned(),
        _ => INVERSE.replace("$panels\n", &work(own).call()),
    };
    completed(&body, kernel, mode)
}

/// A template with the branches alone that a kernel has: for last rows that are no four, and for the fast mode.
fn completed(text: &str, kernel: &Kernel, mode: Mode) -> String {
    let text = decided(text, "EDGE", !kernel.dims[0].is_multiple_of(4));
    decided(&text, "FAST", mode == Mode::Fast)
}

/// Returns the work that threads share in an inverse.
fn work(own: Own<'static>) -> Work<'static> {
    Work { name: "invert_panels", shared: &SHARED, own: Some(own) }
}

const SHARED: [(&str, &str); 3] =
    [("const elimination_t *", "elimination"), ("$real *", "a"), ("bool", "finite")];
