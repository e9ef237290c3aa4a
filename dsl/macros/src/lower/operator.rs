//! Operators that may be functions: `+ - * /` and the sign.
//!
//! What `q * v` means depends on the types of both. So a slot sees each operand. Which function of the library is
//! meant, if any, the builder says, which knows the types ([`tree::Operator`]); which of an author's, rustc: the witness
//! copy asks it whether the two have one.

use bessemer_ir::tree::{self, BinaryOp, ExprKind};
use proc_macro2::Span;
use quote::quote_spanned;
use syn::spanned::Spanned;

use super::{GENERATING, Lowering, own_name, slot_name};

impl Lowering<'_> {
    /// An operand: a slot sees its type.
    pub(super) fn operand(&mut self, op: BinaryOp, expr: &mut syn::Expr, side: Side) -> tree::Expr {
        let operand = self.glanced(op, expr);
        if has_functions(op) {
            side.sees(expr);
        }
        operand
    }

    /// The value of `place op= value`. Of a place that takes computing to name, nobody asks for a function.
    pub(super) fn assigned(
        &mut self,
        op: BinaryOp,
        place: &tree::Expr,
        expr: &mut syn::Expr,
    ) -> tree::Expr {
        let value = self.glanced(op, expr);
        if is_noted(op, place) {
            Side::Right.sees(expr);
        }
        value
    }

    fn glanced(&mut self, op: BinaryOp, expr: &mut syn::Expr) -> tree::Expr {
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
        let (at, op, operands, of) = match (kind, slot) {
            (ExprKind::Binary(op, left, right), Some(slot)) if has_functions(*op) => {
                (slot, Some(*op), vec![left.slot, right.slot], name(*op))
            }
            (ExprKind::Unary(tree::UnaryOp::Neg, _), Some(slot)) => {
                (slot, None, vec![Some(slot)], "Neg")
            }
            (ExprKind::Assign(Some(op), place, value), _) if is_noted(*op, place) => {
                place.slot = Some(self.look_at_place(expr));
                (
                    place.slot.unwrap_or_default(),
                    Some(*op),
                    vec![place.slot, value.slot],
                    assigning(*op),
                )
            }
            _ => return,
        };
        if GENERATING {
            let own = own_name(self.operators.len());
            let of = syn::Ident::new(of, Span::call_site());
            let sides = [Side::Left.name(), Side::Right.name()];
            let sides = &sides[..operands.len()];
            let (first, second) = (sides.first(), sides.last());
            // In parentheses: what begins with a brace would be the body of a loop over `0..n + 1`.
            *expr = syn::Expr::Verbatim(quote_spanned! { expr.span() => ({
                #(let #sides = ::bessemer::generate::Slot::new();)*
                __operated(&#own, #expr, __settled(&__operands::<::bessemer::generate::sign::#of, _, _>(&#first, &#second)).__own())
            }) });
        }
        self.operators.push(tree::Operator { at, op, operands });
    }

    /// Lets a slot see the place of `place op= value`.
    fn look_at_place(&mut self, expr: &mut syn::Expr) -> u32 {
        let slot = self.slot();
        if let (true, syn::Expr::Binary(it)) = (GENERATING, &*expr) {
            let (name, place, left) = (slot_name(slot), &it.left, Side::Left.name());
            *expr = syn::Expr::Verbatim(quote_spanned! { expr.span() => {
                __look(&#name, &#place);
                __placed(&#left, &#place);
                #expr;
            } });
        }
        slot
    }
}

/// A side of an operator, with a slot of its own in the witness copy: that of a function may be told the type later,
/// and cannot hold a reference.
#[derive(Clone, Copy)]
pub(super) enum Side {
    Left,
    Right,
}

impl Side {
    fn name(self) -> syn::Ident {
        let name = match self {
            Side::Left => "__left",
            Side::Right => "__right",
        };
        syn::Ident::new(name, Span::call_site())
    }

    /// Lets the slot see an operand.
    fn sees(self, expr: &mut syn::Expr) {
        if GENERATING {
            let name = self.name();
            *expr = syn::Expr::Verbatim(quote_spanned! { expr.span() => __see(&#name, #expr) });
        }
    }
}

/// Lets a slot see what is behind a sign. Rustc expects of that what it expects of the whole, though it may be a
/// reference.
pub(super) fn see_signed(expr: &mut syn::Expr) {
    if GENERATING {
        let name = Side::Left.name();
        *expr = syn::Expr::Verbatim(quote_spanned! { expr.span() => __operand(&#name, #expr) });
    }
}

fn is_noted(op: BinaryOp, place: &tree::Expr) -> bool {
    has_functions(op) && is_named(place)
}

fn has_functions(op: BinaryOp) -> bool {
    matches!(op, BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul | BinaryOp::Div)
}

/// The trait of an operator.
fn name(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "Add",
        BinaryOp::Sub => "Sub",
        BinaryOp::Mul => "Mul",
        _ => "Div",
    }
}

/// That of the operator with `=`.
fn assigning(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "AddAssign",
        BinaryOp::Sub => "SubAssign",
        BinaryOp::Mul => "MulAssign",
        _ => "DivAssign",
    }
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
