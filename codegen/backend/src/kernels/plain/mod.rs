//! Kernels as plain loops in nalgebra's order: short, portable, and the reference for faster variants.

mod inverse;
mod inverse_of_four;
mod lu;
mod product;
mod tr_mul;
mod triangular;

use bessemer_ir::{Int, Kernel, KernelRoutine, Scalar};

use super::{Buffer, Source};

/// Returns the C of a kernel.
pub(super) fn source(kernel: &Kernel) -> Source {
    match (kernel.routine, kernel.dims.as_slice()) {
        (
            KernelRoutine::Product | KernelRoutine::ProductTr | KernelRoutine::TrProduct,
            &[rows, inner, columns],
        ) => product::product(kernel, rows, inner, columns),
        (KernelRoutine::TrMul, &[rows, left, right]) => tr_mul::tr_mul(kernel, rows, left, right),
        (KernelRoutine::LuSolve, &[size, cols]) => lu::solve(kernel, size, cols, false),
        (KernelRoutine::Solve, &[size, cols]) => lu::solve(kernel, size, cols, true),
        (KernelRoutine::Inverse, &[size @ 1..=4]) => inverse::by_cofactors(kernel, size),
        (KernelRoutine::Inverse, &[size]) => lu::inverse(kernel, size),
        (KernelRoutine::Determinant, &[size @ 1..=3]) => inverse::determinant(kernel, size),
        (KernelRoutine::Determinant, &[size]) => lu::determinant(kernel, size),
        (KernelRoutine::CholeskySolve, &[size, cols]) => triangular::cholesky(kernel, size, cols),
        (KernelRoutine::SolveLower, &[size, cols]) => triangular::lower(kernel, size, cols),
        (KernelRoutine::SolveUpper, &[size, cols]) => triangular::upper(kernel, size, cols),
        (KernelRoutine::TrSolveLower, &[size, cols]) => triangular::tr_lower(kernel, size, cols),
        (KernelRoutine::TrSolveUpper, &[size, cols]) => triangular::tr_upper(kernel, size, cols),
        _ => unreachable!("Cholesky's factor is in `cholesky`; the validator counts dimensions"),
    }
}

/// Returns a source without its code for compilers with vectors; one variant in C99 remains.
pub(super) fn alone(source: Source) -> Source {
    let text = |text: &str| {
        let (mut left, mut beside) = (String::new(), false);
        for line in text.lines() {
            let word = line.trim_start().trim_start_matches('#').split(' ').next();
            match (line.trim_start().starts_with('#'), word) {
                (true, Some("if" | "elif")) => beside = true,
                (true, Some("else" | "endif")) => beside = false,
                _ if beside => {}
                _ => left.extend([line, "\n"]),
            }
        }
        left
    };
    Source { before: text(&source.before), body: text(&source.body), ..source }
}

/// Returns the working memory of a kernel.
pub(super) fn buffers(kernel: &Kernel) -> Vec<Buffer> {
    let element = Scalar::Float(kernel.element);
    let factors = |size: u32| Buffer {
        name: "factors",
        element,
        len: size * size,
        holds: "The matrix, then its factors.",
    };
    let pivots = |size: u32| Buffer {
        name: "pivots",
        element: Scalar::Int(Int::U32),
        len: size,
        holds: "The row that each step exchanges with its own.",
    };
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Inverse, &[size]) if size > 4 => vec![factors(size), pivots(size)],
        (KernelRoutine::Solve, &[size, _]) => vec![factors(size)],
        (KernelRoutine::Determinant, &[size]) if size > 3 => vec![factors(size)],
        _ => Vec::new(),
    }
}
