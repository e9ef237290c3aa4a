//! Operators that may be functions: `+ - * / %`, bit operators, `!` and the sign.
//!
//! The meaning of `q * v` depends on both types, so a slot sees each operand. The builder, which knows the types,
//! selects a function of the library ([`tree::Operator`]); for an author's function the witness copy queries rustc.
//!
//! In the copy, a left operand that is such an operator is a separate statement before ([`Lowering::before`]):
//! rustc's time grows with the square of the nesting of uninferred expressions, and a long sum nests as deep. rustc
//! has no expected type for a left operand, so it infers the same.

use bessemer_tree as tree;
use bessemer_tree::{BinaryOp, ExprKind};
use proc_macro2::Span;
use quote::quote_spanned;

use super::names::{generating, own_name, slot_name, span};
use super::walk::{Lowering, glance_in, wrap};

impl Lowering {
    /// Lowers an operand; a slot sees its type, unless it is a name, whose type can be queried.
    pub(super) fn operand(
        &mut self,
        op: BinaryOp,
        expr: &mut syn::Expr,
        side: Side,
    ) -> (tree::Expr, Option<syn::Ident>) {
        let (operand, glanced) = self.glanced(op, expr);
        if sign(op).is_none() {
            return (operand, None);
        }
        let name = name_of(&operand, expr);
        match (&name, glanced) {
            (None, _) => side.sees(glanced, expr),
            (Some(_), Some(slot)) => glance_in(slot, expr),
            (Some(_), None) => {}
        }
        (operand, name)
    }

    /// Lowers the value of `place op= value`. Only a part of a variable can have an operator function.
    pub(super) fn assigned(
        &mut self,
        op: BinaryOp,
        place: &tree::Expr,
        expr: &mut syn::Expr,
    ) -> tree::Expr {
        let (value, glanced) = self.glanced(op, expr);
        match glanced {
            _ if is_named(place) && sign(op).is_some() => Side::Right.sees(glanced, expr),
            Some(slot) => glance_in(slot, expr),
            None => {}
        }
        value
    }

    /// Lowers an operand; also returns the slot that must still see it, if there is one.
    fn glanced(&mut self, op: BinaryOp, expr: &mut syn::Expr) -> (tree::Expr, Option<u32>) {
        let mut operand = self.value(expr);
        if sign(op).is_none() || operand.slot.is_some() || operand.is_unsuffixed() {
            return (operand, None);
        }
        operand.slot = Some(self.slot());
        let slot = operand.slot;
        (operand, slot)
    }

    /// Records an operator with its value in `slot`. With `chained` it is the left operand of another operator.
    pub(super) fn operator(
        &mut self,
        kind: &mut ExprKind,
        slot: Option<u32>,
        expr: &mut syn::Expr,
        chained: bool,
    ) {
        let names = std::mem::take(&mut self.sides);
        let operates = matches!(kind, ExprKind::Binary(..));
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
        if generating() {
            let own = own_name(self.operators.len());
            let [named_left, named_right] = names.each_ref().map(Option::is_some);
            let asks = match (named_left, named_right) {
                (false, false) => "__operands",
                (true, false) => "__named_left",
                (false, true) => "__named_right",
                (true, true) => "__named",
            };
            let [of, asks] = [&*of, asks].map(|name| syn::Ident::new(name, Span::call_site()));
            let sides = [Side::Left, Side::Right].map(Side::name);
            let open = names.iter().zip(&sides).take(operands.len());
            let open: Vec<_> = open.filter(|(name, _)| name.is_none()).map(|it| it.1).collect();
            let [left, right] = &names;
            let first = left.as_ref().unwrap_or(&sides[0]);
            let second = right.as_ref().unwrap_or(&sides[operands.len() - 1]);
            let span = span(expr);
            let function = quote_spanned! { span =>
                __settled(&#asks::<::bessemer::generate::sign::#of, _, _>(&#first, &#second)).__own()
            };
            let value = if operates {
                let slot = slot_name(at);
                quote_spanned! { span => __computed(&#own, &#slot, #expr, #function) }
            } else {
                quote_spanned! { span => __operated(&#own, #expr, #function) }
            };
            let value = quote_spanned! { span => #(let #open = [];)* #value };
            *expr = syn::Expr::Verbatim(if chained {
                let name = syn::Ident::new("__before", Span::mixed_site());
                self.before.push(quote_spanned! { span => let #name = { #value }; });
                quote_spanned! { span => #name }
            } else {
                let before = std::mem::take(&mut self.before);
                // In parentheses: what begins with a brace would be the body of a loop over `0..n + 1`.
                quote_spanned! { span => ({ #(#before)* #value }) }
            });
        }
        self.operators.push(tree::Operator { at, of, operands });
    }

    /// Makes a slot see the place of `place op= value`.
    fn look_at_place(&mut self, expr: &mut syn::Expr) -> u32 {
        let slot = self.slot();
        if let (true, syn::Expr::Binary(it)) = (generating(), &*expr) {
            let (name, place, left) = (slot_name(slot), &it.left, Side::Left.name());
            *expr = syn::Expr::Verbatim(quote_spanned! { span(expr) => {
                __look(&#name, &#place);
                __placed(&#left, &#place);
                #expr;
            } });
        }
        slot
    }
}

/// Operand of an operator, with a slot of its own in the witness copy. The type of a function's result may be inferred
/// later, and cannot hold a reference.
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

    /// Makes the operand's slot see it, and also the slot `glanced` if there is one.
    fn sees(self, glanced: Option<u32>, expr: &mut syn::Expr) {
        let function = if glanced.is_some() { "__both" } else { "__see" };
        let own = std::iter::once_with(|| self.name());
        wrap(expr, function, own.chain(glanced.into_iter().map(slot_name)));
    }
}

/// Makes a slot see the operand of a sign. rustc expects for it the type of the whole, though it may be a reference.
pub(super) fn see_signed(expr: &mut syn::Expr) {
    wrap(expr, "__operand", std::iter::once_with(|| Side::Left.name()));
}

/// Returns the trait of an operator whose result may be of any type.
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

/// Returns the operator of syn's token, and true if it assigns, as `+=`.
pub(super) fn written(op: &syn::BinOp) -> Option<(BinaryOp, bool)> {
    Some(match op {
        syn::BinOp::Add(_) => (BinaryOp::Add, false),
        syn::BinOp::Sub(_) => (BinaryOp::Sub, false),
        syn::BinOp::Mul(_) => (BinaryOp::Mul, false),
        syn::BinOp::Div(_) => (BinaryOp::Div, false),
        syn::BinOp::Rem(_) => (BinaryOp::Rem, false),
        syn::BinOp::BitAnd(_) => (BinaryOp::And, false),
        syn::BinOp::BitOr(_) => (BinaryOp::Or, false),
        syn::BinOp::BitXor(_) => (BinaryOp::Xor, false),
        syn::BinOp::Shl(_) => (BinaryOp::Shl, false),
        syn::BinOp::Shr(_) => (BinaryOp::Shr, false),
        syn::BinOp::Eq(_) => (BinaryOp::Eq, false),
        syn::BinOp::Ne(_) => (BinaryOp::Ne, false),
        syn::BinOp::Lt(_) => (BinaryOp::Lt, false),
        syn::BinOp::Le(_) => (BinaryOp::Le, false),
        syn::BinOp::Gt(_) => (BinaryOp::Gt, false),
        syn::BinOp::Ge(_) => (BinaryOp::Ge, false),
        syn::BinOp::And(_) => (BinaryOp::LogicAnd, false),
        syn::BinOp::Or(_) => (BinaryOp::LogicOr, false),
        syn::BinOp::AddAssign(_) => (BinaryOp::Add, true),
        syn::BinOp::SubAssign(_) => (BinaryOp::Sub, true),
        syn::BinOp::MulAssign(_) => (BinaryOp::Mul, true),
        syn::BinOp::DivAssign(_) => (BinaryOp::Div, true),
        syn::BinOp::RemAssign(_) => (BinaryOp::Rem, true),
        syn::BinOp::BitAndAssign(_) => (BinaryOp::And, true),
        syn::BinOp::BitOrAssign(_) => (BinaryOp::Or, true),
        syn::BinOp::BitXorAssign(_) => (BinaryOp::Xor, true),
        syn::BinOp::ShlAssign(_) => (BinaryOp::Shl, true),
        syn::BinOp::ShrAssign(_) => (BinaryOp::Shr, true),
        _ => return None,
    })
}

/// Returns true if an expression is one of these operators between two operands.
pub(super) fn is_operator(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Binary(it) => {
            written(&it.op).is_some_and(|(op, assigns)| !assigns && sign(op).is_some())
        }
        syn::Expr::Paren(it) => is_operator(&it.expr),
        syn::Expr::Group(it) => is_operator(&it.expr),
        _ => false,
    }
}

/// Returns true if the form of a sign's operand shows a number or a condition.
pub(super) fn is_builtin(operand: &tree::Expr) -> bool {
    match &operand.kind {
        ExprKind::Int(..) | ExprKind::Float(..) | ExprKind::Bool(_) => true,
        ExprKind::Binary(op, ..) => sign(*op).is_none(),
        _ => false,
    }
}

/// Returns the name of an operand in the witness copy, if it has one: a local, or the variable of a statement before.
fn name_of(operand: &tree::Expr, expr: &syn::Expr) -> Option<syn::Ident> {
    match (&operand.kind, expr) {
        (ExprKind::Local(_), syn::Expr::Path(it)) => it.path.get_ident().cloned(),
        (ExprKind::Binary(..), syn::Expr::Verbatim(tokens)) => syn::parse2(tokens.clone()).ok(),
        _ => None,
    }
}

/// Returns true if a place is a variable, or a part of one.
fn is_named(place: &tree::Expr) -> bool {
    match &place.kind {
        ExprKind::Local(_) => true,
        ExprKind::Field(base, _) | ExprKind::Deref(base) | ExprKind::Index(base, _) => {
            is_named(base)
        }
        _ => false,
    }
}
