//! Literals: from the author's digits to words of the type that the context gives.

use bessemer_ir::tree::{self, BinaryOp, Builtin, MatrixMethod, Site};
use bessemer_ir::{Expr, ExprKind, Float, Scalar, Type};

use super::lowering::Lowering;
use super::value::Value;
use super::{OUR_FAULT, Result, problem};

/// The word of an integer literal as a value of `scalar`.
pub(super) fn integer(digits: &str, negative: bool, scalar: Scalar, site: Site) -> Result<u64> {
    let value = match digits.strip_prefix("0x") {
        Some(digits) => i128::from_str_radix(digits, 16),
        None => digits.parse::<i128>(),
    };
    let Ok(value) = value else {
        return problem(site, "this literal is out of range", OUR_FAULT);
    };
    let value = if negative { -value } else { value };
    match scalar {
        Scalar::Int(int) if (int.min()..=int.max()).contains(&value) => Ok(value as u64),
        Scalar::Float(_) => {
            let digits = if negative { format!("-{digits}") } else { digits.to_owned() };
            float(&digits, scalar, site)
        }
        _ => problem(
            site,
            format!("this literal is out of range for `{}`", scalar.name()),
            OUR_FAULT,
        ),
    }
}

/// The word of an operation on two integer literals, where it has one.
pub(super) fn folded(op: BinaryOp, left: &Expr, right: &Expr) -> Option<u64> {
    let (ExprKind::Literal(a), ExprKind::Literal(b)) = (&left.kind, &right.kind) else {
        return None;
    };
    let int = left.ty.as_int().filter(|_| left.ty == right.ty)?;
    let (a, b) = (int.from_word(*a), int.from_word(*b));
    let value = match op {
        BinaryOp::Add => a.checked_add(b),
        BinaryOp::Sub => a.checked_sub(b),
        BinaryOp::Mul => a.checked_mul(b),
        BinaryOp::Div => a.checked_div(b),
        BinaryOp::Rem => a.checked_rem(b),
        _ => None,
    }?;
    (int.min()..=int.max()).contains(&value).then_some(value as u64)
}

/// The word of a float literal as a value of `scalar`.
pub(super) fn float(digits: &str, scalar: Scalar, site: Site) -> Result<u64> {
    let word = match scalar {
        Scalar::Float(Float::F64) => digits.parse::<f64>().ok().map(f64::to_bits),
        Scalar::Float(Float::F32) => {
            digits.parse::<f32>().ok().map(|value| u64::from(value.to_bits()))
        }
        _ => None,
    };
    match word {
        Some(word) => Ok(word),
        None => problem(site, "this literal is not a float here", OUR_FAULT),
    }
}

/// The type of a literal: its suffix, or what is expected, or Rust's default. A float may be expected of an integer's digits.
pub(super) fn type_of(suffix: Option<Scalar>, expected: Option<&Type>, default: Scalar) -> Scalar {
    match (suffix, expected, default) {
        (Some(scalar), ..) => scalar,
        (None, Some(Type::Scalar(scalar @ Scalar::Float(_))), _) => *scalar,
        (None, Some(Type::Scalar(scalar @ Scalar::Int(_))), Scalar::Int(_)) => *scalar,
        _ => default,
    }
}

impl Lowering<'_, '_> {
    /// Whether a number is made of those that an instance of something generic is made with, of the size of a matrix, or of
    /// those that an expanded function is called with.
    pub(super) fn is_of_instance(&self, expr: &tree::Expr) -> bool {
        match &expr.kind {
            tree::ExprKind::Path(_, name) => {
                self.source.generics.iter().any(|(known, argument)| {
                    known == name && matches!(argument, tree::Argument::Number(..))
                })
            }
            tree::ExprKind::Call(callee, _) => matches!(
                self.builtin_of(*callee),
                Some(Builtin::Matrix(
                    MatrixMethod::Rows | MatrixMethod::Cols | MatrixMethod::Elements
                ))
            ),
            tree::ExprKind::Local(name) if !self.expanding.is_empty() => {
                matches!(self.lookup(name, expr.site), Ok(Value::Word(it)) if it.is_literal())
            }
            tree::ExprKind::Binary(_, a, b) => self.is_of_instance(a) || self.is_of_instance(b),
            _ => false,
        }
    }
}
