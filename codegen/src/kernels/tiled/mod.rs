//! Kernels in tiles: fast, and exact in order.
//!
//! The matrix goes through panels of columns, from left to right ("left-looking", Golub and Van Loan,
//! *Matrix Computations*, chapter 3). A tile, four rows of a panel, is loaded once, goes through every
//! column on its left in their order, and is stored once: each element sees nalgebra's operations in
//! nalgebra's order, whatever the width of a panel.
//!
//! One text serves all targets: [`lanes`] says what a row of a panel is (two vectors of the target, or
//! four numbers), and the rest of the templates, C files beside this one, says what happens to rows.
//!
//! Absent: loops over k across lanes, fused operations, anything that would round differently.

mod lanes;
mod lu;

use bessemer_ir::{Kernel, KernelRoutine};

use super::{Buffer, Source};

/// The C of a kernel, if it gains by tiles.
pub(super) fn source(kernel: &Kernel) -> Option<Source> {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::LuSolve | KernelRoutine::Solve, &[size, columns])
            if size >= lu::SMALLEST =>
        {
            Some(lu::solve(kernel, size, columns))
        }
        (KernelRoutine::Inverse, &[size]) if size >= lu::SMALLEST => {
            Some(lu::inverse(kernel, size))
        }
        _ => None,
    }
}

/// The memory that a kernel in tiles works with.
pub(super) fn buffers(kernel: &Kernel) -> Option<Vec<Buffer>> {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::LuSolve | KernelRoutine::Solve, &[size, _]) if size >= lu::SMALLEST => {
            Some(lu::buffers(kernel, size, false))
        }
        (KernelRoutine::Inverse, &[size]) if size >= lu::SMALLEST => {
            Some(lu::buffers(kernel, size, true))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use bessemer_ir::{Float, Kernel, KernelRoutine};

    use crate::kernels::source;

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
                    (KernelRoutine::Inverse, vec![size]),
                ] {
                    let kernel = Kernel::new(routine, element, &dims).expect("sound");
                    let text = source(&kernel);
                    assert!(!(text.before + &text.body).contains('$'), "{}", kernel.name());
                }
            }
        }
    }
}
