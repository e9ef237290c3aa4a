//! Computes the type of an expression from its operands, for printer and parser: the printer states a type only if it
//! differs.
//!
//! Invariant: only definitions that the parser has read are used.
//!
//! No checks: if operands do not fit, the result is `None`, or a type that the printer finds different.

use alloc::boxed::Box;

use crate::ir::{ExprKind, Intrinsic, Module, Place, Routine, Type};

/// The definitions above the current place.
pub(super) struct Scope<'a> {
    pub module: &'a Module,
    /// Number of complete functions.
    pub functions: usize,
}

impl Scope<'_> {
    /// Returns the type of `place`, whose root has the type `root`.
    pub fn place(&self, root: Option<&Type>, place: &Place) -> Option<Type> {
        place.steps.iter().try_fold(root?.clone(), |ty, step| self.module.step_type(&ty, step))
    }

    /// Returns the type of an expression of this kind; none for literals, structs and empty lists, whose text states
    /// it.
    pub fn expr(&self, kind: &ExprKind) -> Option<Type> {
        match kind {
            ExprKind::Literal(_) | ExprKind::Struct(_) | ExprKind::Cast(_) => None,
            ExprKind::Splat(_) | ExprKind::Matrix(_) => None,
            ExprKind::Const(id) => self.module.consts.get(id.index()).map(|known| known.ty.clone()),
            ExprKind::Load(place) => Some(place.ty.clone()),
            ExprKind::Unary(_, operand) | ExprKind::Binary(_, operand, _) => {
                Some(operand.ty.clone())
            }
            ExprKind::Compare(..) | ExprKind::Logic(..) => Some(Type::BOOL),
            ExprKind::Intrinsic(function, operands) => intrinsic(*function, &operands.first()?.ty),
            ExprKind::Call(id, _) => {
                let known = self.module.functions.get(..self.functions)?.get(id.index())?;
                Some(known.result.clone())
            }
            ExprKind::Array(elements) => Some(Type::Array {
                element: Box::new(elements.first()?.ty.clone()),
                len: u32::try_from(elements.len()).ok()?,
            }),
            ExprKind::Routine(what, operands) => {
                routine(*what, &operands.first()?.ty, operands.get(1).map(|operand| &operand.ty))
            }
        }
    }
}

/// Returns the type of a matrix with these dimensions, or of an array if there is one dimension.
pub(super) fn spread(element: &Type, rows: u32, cols: Option<u32>) -> Option<Type> {
    match (cols, element) {
        (None, _) => Some(Type::Array { element: Box::new(element.clone()), len: rows }),
        (Some(cols), Type::Scalar(element)) => Some(Type::Matrix { element: *element, rows, cols }),
        _ => None,
    }
}

fn intrinsic(function: Intrinsic, operand: &Type) -> Option<Type> {
    let known = match operand {
        Type::Scalar(scalar) => function.result(*scalar).map(Type::Scalar),
        _ => None,
    };
    let same = !matches!(function, Intrinsic::ToBits | Intrinsic::RawBits | Intrinsic::FromBits);
    known.or_else(|| same.then(|| operand.clone()))
}

fn routine(what: Routine, first: &Type, second: Option<&Type>) -> Option<Type> {
    let Type::Matrix { element, rows, cols } = *first else { return None };
    let second_cols = || match second? {
        Type::Matrix { cols, .. } => Some(*cols),
        _ => None,
    };
    Some(match what {
        Routine::Product => Type::Matrix { element, rows, cols: second_cols()? },
        Routine::TrMul => Type::Matrix { element, rows: cols, cols: second_cols()? },
        Routine::Transpose => Type::Matrix { element, rows: cols, cols: rows },
        Routine::Dot | Routine::Norm | Routine::NormSquared | Routine::Amax | Routine::Amin => {
            Type::Scalar(element)
        }
        _ => first.clone(),
    })
}
