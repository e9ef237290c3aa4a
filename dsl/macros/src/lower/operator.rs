//! Operators that may be functions: `+ - * / %`, those of bits, `!` and the sign.
//!
//! What `q * v` means depends on the types of both. So a slot sees each operand. Which function of the library is
//! meant, if any, the builder says, which knows the types ([`tree::Operator`]); which of an author's, rustc: the witness
//! copy asks it whether the two have one.

use bessemer_ir::tree::{self, BinaryOp, ExprKind};
use proc_macro2::Span;
use quote::quote_spanned;
use syn::spanned::Spanned;

use super::names::{GENERATING, own_name, slot_name};
use super::walk::Lowering;

impl Lowering<'_> {
    /// An operand: a slot sees its type.
    pub(super) fn operand(&mut self, op: BinaryOp, expr: &mut syn::Expr, side: Side) -> tree::Expr {
        let operand = self.glanced(op, expr);
        if sign(op).is_some() {
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
        if is_named(place) && sign(op).is_some() {
            Side::Right.sees(expr);
        }
        value
    }

    fn glanced(&mut self, op: BinaryOp, expr: &mut syn::Expr) -> tree::Expr {
        let mut operand = self.value(expr);
        if sign(op).is_some() && operand.slot.is_none() && !is_literal(&operand) {
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
        let (at, operands, of) = match (kind, slot) {
            (ExprKind::Binary(op, left, right), Some(slot)) if let Some(sign) = sign(*op) => {
                (slot, vec![left.slot, right.slot], String::from(sign))
            }
            (ExprKind::Unary(op, operand), Some(slot)) if !is_builtin(operand) => {
                let sign = if *op == tree::UnaryOp::Neg { "Neg" } else { "Not" };
                (slot, vec![Some(slot)], String::from(sign))
            }
            (ExprKind::Assign(Some(op), place, value), _)
                if is_named(place)
                    && let Some(sign) = sign(*op) =>
            {
                let slot = self.look_at_place(expr);
                place.slot = Some(slot);
                (slot, vec![Some(slot), value.slot], format!("{sign}Assign"))
            }
            _ => return,
        };
        if GENERATING {
            let own = own_name(self.operators.len());
            let of = syn::Ident::new(&of, Span::call_site());
            let sides = [Side::Left.name(), Side::Right.name()];
            let sides = &sides[..operands.len()];
            let (first, second) = (sides.first(), sides.last());
            // In parentheses: what begins with a brace would be the body of a loop over `0..n + 1`.
            *expr = syn::Expr::Verbatim(quote_spanned! { expr.span() => ({
                #(let #sides = ::bessemer::generate::Slot::NEW;)*
                __operated(&#own, #expr, __settled(&__operands::<::bessemer::generate::sign::#of, _, _>(&#first, &#second)).__own())
            }) });
        }
        self.operators.push(tree::Operator { at, of, operands });
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

/// The trait of an operator whose result is not always `bool`.
pub(super) fn sign(op: BinaryOp) -> Option<&'static str> {
    Some(match op {
        BinaryOp::Add => "Add",
        BinaryOp::Sub => "Sub",
        BinaryOp::Mul => "Mul",
        BinaryOp::Div => "Div",
        BinaryOp::Rem => "Rem",
        BinaryOp::And => "BitAnd",
        BinaryOp::Or => "BitOr",
        BinaryOp::Xor => "BitXor",
        BinaryOp::Shl => "Shl",
        BinaryOp::Shr => "Shr",
        _ => return None,
    })
}

/// Whether what is behind a sign is a number or a condition by its form alone.
pub(super) fn is_builtin(operand: &tree::Expr) -> bool {
    match &operand.kind {
        ExprKind::Int(..) | ExprKind::Float(..) | ExprKind::Bool(_) => true,
        ExprKind::Binary(op, ..) => sign(*op).is_none(),
        _ => false,
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
