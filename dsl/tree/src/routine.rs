//! The routines of linear algebra that are functions of their own.
//!
//! Invariant: what one computes follows from it, the element type and the dimensions alone, bit for bit, in nalgebra's order
//! of operations.
//!
//! What it must not know: how it is computed.

use serde::{Deserialize, Serialize};

/// The computation of a kernel, and its dimensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum KernelRoutine {
    /// `a * b`; rows of `a`, columns of `a`, columns of `b`. Per output the first product, then k
    /// ascending `y = a_k * b_k + y`.
    Product,
    /// `a * b.transpose()` in the order of a product; rows of `a`, columns of both, rows of `b`.
    ProductTr,
    /// `a.transpose() * b` in the order of a product; columns of `a`, rows of both, columns of `b`.
    TrProduct,
    /// `a.tr_mul(&b)`; rows of both, columns of `a`, columns of `b`. Per output the `dot` of two columns.
    TrMul,
    /// Solves `a x = b` in place by elimination with row pivots. `a` becomes its factors as nalgebra packs them, `b`
    /// the solution, and the result is `true`. If `a` is singular, the result is `false`, and both are NaN in every
    /// element. Dimensions: the size, the columns of `b`.
    LuSolve,
    /// Solves `a x = b` in place of `b` in the same way; `a` stays as it is. `false`, and NaN in `b`, where `a` is
    /// singular. The size, the columns of `b`.
    Solve,
    /// Inverts `a` in place; `false`, and `a` as it was, where it is singular. The size. Up to 4 by
    /// cofactors, above by elimination.
    Inverse,
    /// The determinant of `a`. The size. Up to 3 by minors, above by elimination.
    Determinant,
    /// Factors a symmetric `a` in place: its lower triangle becomes L, what is above stays. `false`, and
    /// NaN in the lower triangle, unless it is positive definite. The size.
    Cholesky,
    /// Computes the Cholesky factor L into the lower triangle of a copy of `a`. The upper part stays; the lower
    /// triangle is NaN unless `a` is positive definite. Dimension: the size.
    CholeskyLower,
    /// Solves `l lᵀ x = b` in place of `b`, of `l` the lower triangle. The size, the columns of `b`.
    CholeskySolve,
    /// Solves `a x = b` in place of `b` with the lower triangle of `a`. If an element of the diagonal is zero, the
    /// result is `false`, and `b` is NaN. Dimensions: the size, the columns of `b`.
    SolveLower,
    /// Solves with the upper triangle.
    SolveUpper,
    /// Solves with the transpose of the lower triangle.
    TrSolveLower,
    /// Solves with the transpose of the upper triangle.
    TrSolveUpper,
}

impl KernelRoutine {
    /// Every routine.
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

    /// `lu_solve`.
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

    /// The routine of this name.
    pub fn from_name(name: &str) -> Option<KernelRoutine> {
        KernelRoutine::ALL.into_iter().find(|routine| routine.name() == name)
    }

    /// One word for its result.
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
