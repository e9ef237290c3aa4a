//! Kernels in tiles: fast, with the exact order of operations.
//!
//! The matrix is processed in panels of columns, from left to right ("left-looking", Golub and Van Loan, *Matrix
//! Computations*, chapter 3). A tile, four rows of a panel, is loaded once, processed with every column on its left
//! in order, and stored once. So each element undergoes nalgebra's operations in nalgebra's order, for any width of a
//! panel.
//!
//! One text serves all targets: [`lanes`] defines a row of a panel (two vectors of the target, or four numbers), and
//! the templates, C files in this folder, define the operations on rows. Where it is faster, [`ordered`] has another
//! text, which leaves the rows in place.
//!
//! Not used: loops over k across lanes, fused operations, or anything that would round differently.

mod lanes;
mod lu;
mod ordered;

use bessemer_ir::{Kernel, KernelRoutine};

use super::{Buffer, Mode, Source};

/// Code size of a solve or an inverse, bytes, on a target with four bytes per instruction.
pub(super) const BYTES: u32 = 5 * 1024;

/// Returns the rows, rounded up to whole tiles.
fn rows(size: u32) -> u32 {
    size.next_multiple_of(4)
}

/// Returns true if a kernel is faster in tiles.
pub(super) fn fits(kernel: &Kernel) -> bool {
    let factored = matches!(
        kernel.routine,
        KernelRoutine::LuSolve | KernelRoutine::Solve | KernelRoutine::Inverse
    );
    factored && kernel.dims[0] >= lu::SMALLEST
}

/// Returns the C of a kernel.
pub(super) fn source(kernel: &Kernel, mode: Mode) -> Source {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Inverse, &[size]) => lu::inverse(kernel, size, mode),
        (_, dims) => lu::solve(kernel, dims[0], dims.get(1).copied().unwrap_or(1), mode),
    }
}

/// Returns the working memory of a kernel in tiles.
pub(super) fn buffers(kernel: &Kernel) -> Vec<Buffer> {
    lu::buffers(kernel, kernel.dims[0], kernel.routine == KernelRoutine::Inverse)
}

#[cfg(test)]
mod tests {
    use bessemer_ir::{Float, Kernel, KernelRoutine};

    use crate::kernels::{Mode, Tuning, source};

    #[test]
    fn nothing_of_a_template_is_left() {
        for element in [Float::F64, Float::F32] {
            for size in 1..=70 {
                for (routine, dims) in [
                    (KernelRoutine::LuSolve, vec![size, 1]),
                    (KernelRoutine::LuSolve, vec![size, 3]),
                    (KernelRoutine::Solve, vec![size, 1]),
                    (KernelRoutine::Cholesky, vec![size]),
                    (KernelRoutine::CholeskySolve, vec![size, 2]),
                    (KernelRoutine::Product, vec![size, size, 3]),
                    (KernelRoutine::Product, vec![size, 7, 1]),
                    (KernelRoutine::Inverse, vec![size]),
                ] {
                    let kernel = Kernel::new(routine, element, &dims).expect("sound");
                    for (code_bytes, mode) in [
                        (8192, Mode::Exact),
                        (2048, Mode::Exact),
                        (512, Mode::Exact),
                        (8192, Mode::Fast),
                    ] {
                        let text =
                            source(&kernel, &Tuning { code_bytes, mode, ..Tuning::default() });
                        assert!(!(text.before + &text.body).contains('$'), "{}", kernel.name());
                    }
                }
            }
        }
    }
}
