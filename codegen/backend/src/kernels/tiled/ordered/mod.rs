//! Large solves and inverses that leave the rows in place, for x86-64 with AVX.
//!
//! A permutation records the row of each pivot, so no rows on the left of a panel are exchanged; multipliers are read
//! from all rows of a tile at once. A panel is factored by columns: each subtracts those on its left, and finds the
//! largest of its magnitudes, the next pivot, meanwhile. A single right-hand side is an additional column. Those of
//! an inverse are processed in panels of their own, two at a time, so that the divisions by U's diagonal overlap.
//!
//! Each element has the order of the tiles, which are in the same file for the other targets.
//!
//! Not for SSE2, where it takes the same time as tiles; AVX-512; ARM; several right-hand sides; and solves that
//! return the factors.

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

/// Smallest size of a row for which it is faster than tiles, bytes.
const SMALLEST: u32 = 512;

/// Returns true if a kernel has this variant.
pub(super) fn fits(kernel: &Kernel) -> bool {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Solve, &[size, 1]) | (KernelRoutine::Inverse, &[size]) => {
            size >= SMALLEST / bytes(kernel.element)
        }
        _ => false,
    }
}

/// Returns the numbers of the panel, and of the memory beside it.
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

/// Returns the numbers of the two permutations of the rows.
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

/// Returns the body of the kernel.
pub(super) fn body(kernel: &Kernel, mode: Mode, own: Own<'static>) -> String {
    let body = match kernel.routine {
        KernelRoutine::Solve => SOLVE.to_owned(),
        _ => INVERSE.replace("$panels\n", &work(own).call()),
    };
    completed(&body, kernel, mode)
}

/// Returns a template with only the branches that a kernel needs: for a remainder of rows, and for the fast mode.
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
