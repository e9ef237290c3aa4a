//! Types of values from rustc's slots and from declarations.
//!
//! Invariant: nothing is lowered, so no statement, local or lender is added.
//!
//! Must not know: how a value is lowered.

use bessemer_ir::tree::{self, BinaryOp as Op, ExprKind as Tree};
use bessemer_ir::{Float, Int, Scalar, Type};

use super::literal::type_of;
use super::lowering::Lowering;
use super::slots::result_of;
use super::value::Value;
use super::{Result, refusals, refused};

impl Lowering<'_, '_> {
    /// Returns the type of the value of an expression.
    pub(super) fn type_of_value(&mut self, expr: &tree::Expr) -> Result<Type> {
        if self.holds_nothing(expr) {
            return Ok(Type::Unit);
        }
        if let Some(Value::Submatrix(part)) = self.meaning(expr) {
            return Ok(part.ty());
        }
        match &expr.kind {
            Tree::Local(_) | Tree::Field(..) | Tree::Index(..) => self.place_type(expr),
            Tree::Ref(_, inner) => self.type_of_value(inner),
            Tree::Deref(inner) => {
                let ty = self.type_of_value(inner)?;
                Ok(self.type_behind(ty))
            }
            _ if let Some(slot) = expr.slot => self.seen(slot, expr.site),
            Tree::Bool(_) => Ok(Type::BOOL),
            Tree::Int(_, suffix) => Ok(number(*suffix, Scalar::Int(Int::I32))),
            Tree::Float(_, suffix) => Ok(number(*suffix, Scalar::Float(Float::F64))),
            Tree::Path(index, name) => Ok(self.path(*index, name, expr.site)?.ty),
            Tree::Unary(_, operand) => self.type_of_value(operand),
            Tree::Binary(op, left, right) => match op {
                Op::Eq | Op::Ne | Op::Lt | Op::Le | Op::Gt | Op::Ge => Ok(Type::BOOL),
                Op::LogicAnd | Op::LogicOr => Ok(Type::BOOL),
                _ if left.is_unsuffixed() => self.type_of_value(right),
                _ => self.type_of_value(left),
            },
            Tree::Call(..) if let Some(ty) = self.called(expr).and_then(|it| result_of(it.0)) => {
                self.cx.pointee(ty, expr.site)
            }
            Tree::Block(block) | Tree::Labelled(_, block) if let Some(tail) = &block.tail => {
                self.type_of_value(tail)
            }
            Tree::If(_, then, Some(otherwise)) => match &then.tail {
                Some(tail) => self.type_of_value(tail),
                None => self.type_of_value(otherwise),
            },
            Tree::Match(_, arms) => {
                let types = arms.iter().map(|arm| self.type_of_value(&arm.body));
                types.reduce(Result::or).unwrap_or_else(|| refused(expr.site, refusals::NO_VALUE))
            }
            _ => refused(expr.site, refusals::NO_VALUE),
        }
    }
}

/// Returns the type of a literal: its suffix, or rustc's choice without one.
fn number(suffix: Option<Scalar>, without: Scalar) -> Type {
    Type::Scalar(type_of(suffix, None, without))
}
