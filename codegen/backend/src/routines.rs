//! Kinds of routines, as the passes and the lowering to C tell them.
//!
//! Must not know: how a routine is computed.

use bessemer_ir::{Expr, Routine, Type};

/// Returns true if a routine works element by element, so that it may nest.
pub(crate) fn is_element_wise(routine: Routine) -> bool {
    match routine {
        Routine::Add
        | Routine::Sub
        | Routine::Neg
        | Routine::Scale
        | Routine::Unscale
        | Routine::ComponentMul
        | Routine::ComponentDiv
        | Routine::Inf
        | Routine::Sup
        | Routine::Abs => true,
        Routine::Product
        | Routine::TrMul
        | Routine::Transpose
        | Routine::Dot
        | Routine::Cross
        | Routine::Norm
        | Routine::NormSquared
        | Routine::Amax
        | Routine::Amin => false,
    }
}

/// Returns true if a routine chooses among the elements of its operand, so that an element-wise operand may nest.
pub(crate) fn reduces(routine: Routine) -> bool {
    matches!(routine, Routine::Amax | Routine::Amin)
}

/// Returns true if a routine is the product of a column and a row, which may nest since each element is one product.
pub(crate) fn outer(routine: Routine, operands: &[Expr]) -> bool {
    routine == Routine::Product && matches!(operands[0].ty, Type::Matrix { cols: 1, .. })
}
