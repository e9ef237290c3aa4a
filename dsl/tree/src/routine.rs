//! Routines of linear algebra with their own functions.
//!
//! Invariant: the result's bits follow only from the routine, the element type and the dimensions, in nalgebra's
//! order of operations.
//!
//! Must not know: the implementation.

use serde::{Deserialize, Serialize};

/// Routine of a kernel, with the meaning of its dimensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum KernelRoutine {
    /// `a * b`. Each element is the first product, then for ascending k `y = a_k * b_k + y`. Dimensions: rows of `a`,
    /// columns of `a`, columns of `b`.
    Product,
    /// `a * b.transpose()` in the order of a product. Dimensions: rows of `a`, columns of both, rows of `b`.
    ProductTr,
    /// `a.transpose() * b` in the order of a product. Dimensions: columns of `a`, rows of both, columns of `b`.
    TrProduct,
    /// `a.tr_mul(&b)`. Each element is the `dot` of two columns. Dimensions: rows of both, columns of `a`, columns of
    /// `b`.
    TrMul,
    /// Solves `a x = b` in place by elimination with row pivots. `a` becomes its factors as nalgebra packs them, `b`
    /// the solution, and the result is `true`. If `a` is singular, the result is `false`, and both are NaN in every
    /// element. Dimensions: the size, the columns of `b`.
    LuSolve,
    /// Solves `a x = b` in place of `b` and leaves `a` unchanged. If `a` is singular, the result is `false`, and `b`
    /// is NaN. Dimensions: the size, the columns of `b`.
    Solve,
    /// Inverts `a` in place, up to size 4 by cofactors, above by elimination. If `a` is singular, the result is
    /// `false`, and `a` is unchanged. Dimension: the size.
    Inverse,
    /// Computes the determinant of `a`, up to size 3 by minors, above by elimination. Dimension: the size.
    Determinant,
    /// Factors a symmetric `a` in place: its lower triangle becomes L, the rest is unchanged. Unless `a` is positive
    /// definite, the result is `false`, and the lower triangle is NaN. Dimension: the size.
    Cholesky,
    /// Computes the Cholesky factor L into the lower triangle of a copy of `a`. The upper part stays; the lower
    /// triangle is NaN unless `a` is positive definite. Dimension: the size.
    CholeskyLower,
    /// Solves `l lᵀ x = b` in place of `b`, where `l` is a lower triangle. Dimensions: the size, the columns of `b`.
    CholeskySolve,
    /// Solves `a x = b` in place of `b` with the lower triangle of `a`. If an element of the diagonal is zero, the
    /// result is `false`, and `b` is NaN. Dimensions: the size, the columns of `b`.
    SolveLower,
    /// Solves like [`SolveLower`](Self::SolveLower), with the upper triangle.
    SolveUpper,
    /// Solves like [`SolveLower`](Self::SolveLower), with the transpose of the lower triangle.
    TrSolveLower,
    /// Solves like [`SolveLower`](Self::SolveLower), with the transpose of the upper triangle.
    TrSolveUpper,
}

impl KernelRoutine {
    /// All routines.
    pub const ALL: [KernelRoutine; 15] = [
        KernelRoutine::Product,
        KernelRoutine::ProductTr,
        KernelRoutine::TrProduct,
        KernelRoutine::TrMul,
        KernelRoutine::LuSolve,
        KernelRoutine::Solve,
        KernelRoutine::Inverse,
        KernelRoutine::Determinant,
        KernelRoutine::Cholesky,
        KernelRoutine::CholeskyLower,
        KernelRoutine::CholeskySolve,
        KernelRoutine::SolveLower,
        KernelRoutine::SolveUpper,
        KernelRoutine::TrSolveLower,
        KernelRoutine::TrSolveUpper,
    ];

    /// Returns the name, such as `lu_solve`.
    pub const fn name(self) -> &'static str {
        match self {
            KernelRoutine::Product => "product",
            KernelRoutine::ProductTr => "product_tr",
            KernelRoutine::TrProduct => "tr_product",
            KernelRoutine::TrMul => "tr_mul",
            KernelRoutine::LuSolve => "lu_solve",
            KernelRoutine::Solve => "solve",
            KernelRoutine::Inverse => "inverse",
            KernelRoutine::Determinant => "determinant",
            KernelRoutine::Cholesky => "cholesky",
            KernelRoutine::CholeskyLower => "cholesky_lower",
            KernelRoutine::CholeskySolve => "cholesky_solve",
            KernelRoutine::SolveLower => "solve_lower",
            KernelRoutine::SolveUpper => "solve_upper",
            KernelRoutine::TrSolveLower => "tr_solve_lower",
            KernelRoutine::TrSolveUpper => "tr_solve_upper",
        }
    }

    /// Returns the routine with this name.
    pub fn from_name(name: &str) -> Option<KernelRoutine> {
        KernelRoutine::ALL.into_iter().find(|routine| routine.name() == name)
    }

    /// Returns one word for its result.
    pub const fn result(self) -> &'static str {
        match self {
            KernelRoutine::Product
            | KernelRoutine::ProductTr
            | KernelRoutine::TrProduct
            | KernelRoutine::TrMul => "product",
            KernelRoutine::LuSolve | KernelRoutine::Solve | KernelRoutine::CholeskySolve => {
                "solved"
            }
            KernelRoutine::SolveLower | KernelRoutine::SolveUpper => "solved",
            KernelRoutine::TrSolveLower | KernelRoutine::TrSolveUpper => "solved",
            KernelRoutine::Cholesky => "factored",
            KernelRoutine::CholeskyLower => "lower",
            KernelRoutine::Inverse => "inverted",
            KernelRoutine::Determinant => "determinant",
        }
    }

    /// Returns the number of dimensions.
    pub const fn dims(self) -> usize {
        match self {
            KernelRoutine::Product
            | KernelRoutine::ProductTr
            | KernelRoutine::TrProduct
            | KernelRoutine::TrMul => 3,
            KernelRoutine::LuSolve
            | KernelRoutine::Solve
            | KernelRoutine::CholeskySolve
            | KernelRoutine::SolveLower
            | KernelRoutine::SolveUpper
            | KernelRoutine::TrSolveLower
            | KernelRoutine::TrSolveUpper => 2,
            KernelRoutine::Inverse
            | KernelRoutine::Determinant
            | KernelRoutine::Cholesky
            | KernelRoutine::CholeskyLower => 1,
        }
    }
}
