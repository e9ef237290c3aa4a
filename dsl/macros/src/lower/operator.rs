//! Operators that may be functions: `+ - * /` and the sign.
//!
//! What `q * v` means depends on the types of both. So a slot sees each operand, and the builder, which
//! knows the types, says which function of the library is meant, if any ([`tree::Operator`]).

use bessemer_ir::tree::{self, BinaryOp, ExprKind};
use quote::quote_spanned;
use syn::spanned::Spanned;

use super::{GENERATING, Lowering, slot_name};

impl Lowering<'_> {
    /// An operand: a slot sees its type.
    pub(super) fn operand(&mut self, op: BinaryOp, expr: &mut syn::Expr) -> tree::Expr {
        let mut operand = self.value(expr);
        if has_functions(op) && operand.slot.is_none() && !is_literal(&operand) {
            operand.slot = Some(self.glance(expr));
        }
        operand
    }

    /// Notes an operator, whose value is in `slot`.
    pub(super) fn operator(
        &mut self,
        kind: &mut ExprKind,
        slot: Option<u32>,
        expr: &mut syn::Expr,
    ) {
        let (at, op, operands) = match (kind, slot) {
            (ExprKind::Binary(op, left, right), Some(slot)) if has_functions(*op) => {
                (slot, Some(*op), vec![left.slot, right.slot])
            }
            (ExprKind::Unary(tree::UnaryOp::Neg, _), Some(slot)) => (slot, None, vec![Some(slot)]),
            (ExprKind::Assign(Some(op), place, value), _) if has_functions(*op) => {
                let Some(slot) = self.look_at_place(place, expr) else { return };
                place.slot = Some(slot);
                (slot, Some(*op), vec![Some(slot), value.slot])
            }
            _ => return,
        };
        self.operators.push(tree::Operator { at, op, operands });
    }

    /// Lets a slot see the place of `place op= value`, if it is a variable or a part of one.
    fn look_at_place(&mut self, place: &tree::Expr, expr: &mut syn::Expr) -> Option<u32> {
        let syn::Expr::Binary(it) = &*expr else { return None };
        if !is_named(place) {
            return None;
        }
        let slot = self.slot();
        if GENERATING {
            let (name, place) = (slot_name(slot), &it.left);
            *expr = syn::Expr::Verbatim(
                quote_spanned! { expr.span() => { __look(&#name, &#place); #expr; } },
            );
        }
        Some(slot)
    }
}

fn has_functions(op: BinaryOp) -> bool {
    matches!(op, BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul | BinaryOp::Div)
}

fn is_literal(expr: &tree::Expr) -> bool {
    match &expr.kind {
        ExprKind::Int(_, suffix) | ExprKind::Float(_, suffix) => suffix.is_none(),
        ExprKind::Unary(_, operand) => is_literal(operand),
        _ => false,
    }
}

/// Whether a place is a variable, or a field of one.
fn is_named(place: &tree::Expr) -> bool {
    match &place.kind {
        ExprKind::Local(_) => true,
        ExprKind::Field(base, _) | ExprKind::Deref(base) => is_named(base),
        // What computes an index is computed once.
        ExprKind::Index(base, index) => {
            is_named(base) && (is_named(index) || matches!(index.kind, ExprKind::Int(..)))
        }
        _ => false,
    }
}
