//! Expressions: values (which a slot sees), places, and unsupported ones.

use bessemer_tree as tree;
use bessemer_tree::number::{Int, Scalar, is_wide};
use bessemer_tree::{ExprKind, UnaryOp};
use quote::ToTokens;

use super::link::is_source;
use super::names::{SELF, UNIT, place, site, text};
use super::operator::Side;
use super::rewrite::held;
use super::syntax::{is_of_type, is_variant, last_segment};
use super::walk::{Constant, Lowering, see_in};
use super::{call, loops, macros, operator, pattern, refuse, signature};

impl Lowering {
    /// Lowers an expression whose value is used.
    pub(super) fn value(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        self.lower(expr, true)
    }

    /// Lowers an expression for its effect.
    pub(super) fn statement(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        self.lower(expr, false)
    }

    fn lower(&mut self, expr: &mut syn::Expr, value: bool) -> tree::Expr {
        let chained = std::mem::take(&mut self.chained);
        let place = place(expr);
        let (mut kind, seen) = self.kind(expr, value);
        let slot = match (&kind, seen) {
            (_, true) if call::may_refer(expr) => Some(self.glance(expr)),
            (ExprKind::Path(index, _), _) => {
                let slot = self.constants.get(*index as usize).map(|it| it.slot);
                if let (true, Some(slot)) = (seen, slot) {
                    see_in(slot, expr);
                }
                slot
            }
            // The operator lets it see.
            (ExprKind::Binary(op, ..), true) if operator::sign(*op).is_some() => Some(self.slot()),
            (_, true) => Some(self.see(expr)),
            _ => None,
        };
        if let (ExprKind::Struct(name, ..), Some(slot)) = (&kind, slot)
            && name != "Self"
        {
            self.literals.push(slot);
        }
        self.operator(&mut kind, slot, expr, chained);
        tree::Expr { kind, site: place, slot }
    }

    /// Returns the kind of `expr`, and true if a slot must see its value.
    fn kind(&mut self, expr: &mut syn::Expr, value: bool) -> (ExprKind, bool) {
        if let Some(other) = self.rewritten(expr) {
            *expr = other;
        }
        if is_source(expr) {
            return (self.handing(expr), false);
        }
        match expr {
            syn::Expr::Lit(it) => (self.literal(&it.lit), is_wide_literal(&it.lit)),
            syn::Expr::Path(it) if it.path.is_ident("None") && it.qself.is_none() => {
                (ExprKind::Constructor("None".into(), Vec::new()), true)
            }
            syn::Expr::Path(it) => {
                // Of what type it is only its use says.
                let open = it.path.segments.last().is_some_and(|it| it.ident == "PhantomData");
                let seen = open || is_variant(&it.path) || is_of_type(&it.path);
                (self.path(it), seen)
            }
            syn::Expr::Paren(it) => self.kind(&mut it.expr, value),
            syn::Expr::Group(it) => self.kind(&mut it.expr, value),
            syn::Expr::Unary(it) => self.unary(it),
            syn::Expr::Binary(it) => self.binary(it),
            syn::Expr::Assign(it) if matches!(&*it.left, syn::Expr::Infer(_)) => {
                (self.value(&mut it.right).kind, false)
            }
            syn::Expr::Assign(it) => {
                let (value, place) = (self.value(&mut it.right), self.value(&mut it.left));
                (ExprKind::Assign(None, Box::new(place), Box::new(value)), false)
            }
            syn::Expr::Call(it) => {
                let kind = self.call(it);
                let seen = value || matches!(kind, ExprKind::Path(..));
                (kind, seen)
            }
            syn::Expr::MethodCall(it) => (self.method_call(it), value),
            syn::Expr::Field(it) => (self.field(it), false),
            syn::Expr::Index(it) if matches!(&*it.index, syn::Expr::Range(_)) => {
                (self.slice(it), false)
            }
            syn::Expr::Index(it) => {
                let (base, index) = (self.value(&mut it.expr), self.index(&mut it.index));
                (ExprKind::Index(Box::new(base), Box::new(index)), false)
            }
            syn::Expr::Tuple(it) => (self.tuple(it), !it.elems.is_empty()),
            syn::Expr::Struct(it) => (self.struct_literal(it), true),
            syn::Expr::Array(it) => (
                ExprKind::Array(it.elems.iter_mut().map(|element| self.part(element)).collect()),
                true,
            ),
            syn::Expr::Repeat(it) => (ExprKind::Repeat(Box::new(self.value(&mut it.expr))), true),
            syn::Expr::Reference(it) => {
                let inner = self.value(&mut it.expr);
                (ExprKind::Ref(it.mutability.is_some(), Box::new(inner)), false)
            }
            syn::Expr::Cast(it) => {
                signature::check_type(&it.ty, &mut self.refusals);
                let mut value = self.value(&mut it.expr);
                // The product of two words needs their types.
                if is_wide_type(&it.ty) && value.slot.is_none() && !value.is_unsuffixed() {
                    value.slot = Some(self.glance(&mut it.expr));
                }
                (ExprKind::Cast(Box::new(value)), true)
            }
            _ => self.control(expr, value),
        }
    }

    fn control(&mut self, expr: &mut syn::Expr, value: bool) -> (ExprKind, bool) {
        match expr {
            syn::Expr::If(it) => {
                let value = value && it.else_branch.is_some();
                (self.if_expr(it, value), value)
            }
            syn::Expr::Match(it) => (self.match_expr(it, value), value),
            syn::Expr::Block(it) => {
                let block = self.block(&mut it.block);
                match &it.label {
                    Some(label) => (ExprKind::Labelled(text(&label.name.ident), block), value),
                    None => (ExprKind::Block(block), value),
                }
            }
            syn::Expr::ForLoop(it) => {
                let (site, unroll) = (site(it), self.unrolled(&mut it.attrs));
                let kind = self.for_loop(it).unwrap_or(UNIT);
                let kind = match unroll {
                    Some(count) => {
                        ExprKind::Unroll(count, Box::new(tree::Expr { kind, site, slot: None }))
                    }
                    None => kind,
                };
                (kind, false)
            }
            syn::Expr::While(it) => (self.while_loop(it).unwrap_or(UNIT), false),
            syn::Expr::Loop(it) => {
                let value = value && loops::gives_value(it);
                (self.endless_loop(it).unwrap_or(UNIT), value)
            }
            syn::Expr::Return(it) => (self.return_expr(it), false),
            syn::Expr::Break(it) => (self.break_expr(it), false),
            syn::Expr::Continue(it) => {
                (ExprKind::Continue(it.label.as_ref().map(|label| text(&label.ident))), false)
            }
            syn::Expr::Try(it) => {
                let operand = Box::new(self.value(&mut it.expr));
                (ExprKind::Try(self.leaves.clone(), operand), value)
            }
            syn::Expr::Macro(it) if it.mac.path.is_ident(macros::MATCHES) => {
                (self.refused(&it.mac.path, refuse::SYNTAX), false)
            }
            syn::Expr::Macro(it) => {
                (self.macro_call(&mut it.mac).map_or(UNIT, |expr| expr.kind), false)
            }
            other => {
                let (place, reason) = refuse::expression(other);
                let kind = self.refused(&place, reason);
                // There may be more to refuse in it.
                if let syn::Expr::Unsafe(it) = other {
                    self.block(&mut it.block);
                }
                (kind, false)
            }
        }
    }

    /// Lowers the content of brackets: an index, or the row and column of a matrix.
    fn index(&mut self, index: &mut syn::Expr) -> tree::Expr {
        match index {
            syn::Expr::Tuple(it) if it.elems.len() == 2 => {
                let site = site(it);
                tree::Expr { kind: self.tuple(it), site, slot: None }
            }
            other => self.value(other),
        }
    }

    /// Lowers `base[from..to]`.
    fn slice(&mut self, it: &mut syn::ExprIndex) -> ExprKind {
        let base = Box::new(self.value(&mut it.expr));
        let syn::Expr::Range(range) = &mut *it.index else { return UNIT };
        let inclusive = matches!(range.limits, syn::RangeLimits::Closed(_));
        let mut end =
            |end: &mut Option<Box<syn::Expr>>| end.as_mut().map(|end| Box::new(self.value(end)));
        let (from, to) = (end(&mut range.start), end(&mut range.end));
        ExprKind::Slice(base, from, to, inclusive)
    }

    /// Lowers a part of a struct, a tuple or an array. A range there is a value, since nothing iterates over it.
    fn part(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        if let Some(range) = held(expr) {
            *expr = range;
        }
        self.value(expr)
    }

    fn tuple(&mut self, it: &mut syn::ExprTuple) -> ExprKind {
        ExprKind::Tuple(it.elems.iter_mut().map(|element| self.part(element)).collect())
    }

    fn literal(&mut self, literal: &syn::Lit) -> ExprKind {
        let code = |code: u32, of: Int| ExprKind::Int(code.to_string(), Some(Scalar::Int(of)));
        match literal {
            syn::Lit::Bool(it) => ExprKind::Bool(it.value),
            syn::Lit::Int(it) => match Scalar::from_name(it.suffix()) {
                None if !it.suffix().is_empty() && !is_wide(it.suffix()) => {
                    self.refused(it, refuse::SUFFIX)
                }
                float @ Some(Scalar::Float(_)) => ExprKind::Float(it.base10_digits().into(), float),
                suffix => ExprKind::Int(digits(it), suffix),
            },
            syn::Lit::Float(it) => {
                ExprKind::Float(it.base10_digits().into(), Scalar::from_name(it.suffix()))
            }
            syn::Lit::Byte(it) => code(it.value().into(), Int::U8),
            syn::Lit::ByteStr(it) => ExprKind::Bytes(it.value()),
            syn::Lit::Char(it) => code(it.value().into(), Int::U32),
            syn::Lit::Str(it) => ExprKind::Path(
                self.held_as(it.to_token_stream(), Constant::Value).1,
                format!("\"{}", it.value()),
            ),
            other => self.refused(other, refuse::STRING),
        }
    }

    fn path(&mut self, it: &mut syn::ExprPath) -> ExprKind {
        if it.qself.is_none()
            && let Some(ident) = it.path.get_ident()
            && self.is_local(&text(ident))
        {
            let name = self.local_name(&text(ident)).unwrap_or_default().to_owned();
            if self.is_closure(&name) {
                self.refusals.add(ident, refuse::CLOSURE_VALUE);
                let known = self.functions.iter().find(|(of, _)| *of == name);
                known.into_iter().for_each(|(_, path)| self.refusals.requires(path.clone()));
            }
            if name == SELF {
                // In the copy, which is a closure, the receiver is an ordinary parameter.
                it.path = syn::Path::from(syn::Ident::new(signature::RECEIVER, ident.span()));
            }
            return ExprKind::Local(name);
        }
        self.constant(it.to_token_stream(), &it.path).kind
    }

    fn unary(&mut self, it: &mut syn::ExprUnary) -> (ExprKind, bool) {
        let operand = Box::new(self.value(&mut it.expr));
        let op = match it.op {
            syn::UnOp::Neg(_) => UnaryOp::Neg,
            syn::UnOp::Not(_) => UnaryOp::Not,
            _ => return (ExprKind::Deref(operand), false),
        };
        let builtin = operator::is_builtin(&operand);
        if !builtin {
            operator::see_signed(&mut it.expr);
        }
        // A negative literal is a literal.
        (ExprKind::Unary(op, operand), op == UnaryOp::Not || !builtin)
    }

    fn binary(&mut self, it: &mut syn::ExprBinary) -> (ExprKind, bool) {
        let Some((op, assigns)) = operator::written(&it.op) else {
            return (self.refused(&it.op, refuse::SYNTAX), false);
        };
        if assigns {
            let place = self.value(&mut it.left);
            let value = self.assigned(op, &place, &mut it.right);
            return (ExprKind::Assign(Some(op), Box::new(place), Box::new(value)), false);
        }
        self.chained = operator::sign(op).is_some() && operator::is_operator(&it.left);
        let (left, first) = self.operand(op, &mut it.left, Side::Left);
        let before = std::mem::take(&mut self.before);
        let (right, second) = self.operand(op, &mut it.right, Side::Right);
        self.before = before;
        self.sides = [first, second];
        (ExprKind::Binary(op, Box::new(left), Box::new(right)), operator::sign(op).is_some())
    }

    fn field(&mut self, it: &mut syn::ExprField) -> ExprKind {
        let base = self.value(&mut it.base);
        ExprKind::Field(Box::new(base), pattern::member(&it.member))
    }

    fn struct_literal(&mut self, it: &mut syn::ExprStruct) -> ExprKind {
        let mut fields = Vec::new();
        for field in &mut it.fields {
            let name = pattern::member(&field.member);
            field.colon_token.get_or_insert_default();
            fields.push((name, self.part(&mut field.expr)));
        }
        let rest = it.rest.as_mut().map(|rest| Box::new(self.value(rest)));
        ExprKind::Struct(last_segment(&it.path), fields, rest)
    }
}

/// Returns true if an expression at the end of a block is a statement all the same: loops, `if` without `else`,
/// assignments.
pub(super) fn is_unit_control(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::ForLoop(_)
        | syn::Expr::While(_)
        | syn::Expr::Assign(_)
        | syn::Expr::Return(_) => true,
        syn::Expr::Loop(it) => !loops::gives_value(it) && !loops::is_endless(it),
        syn::Expr::If(it) => it.else_branch.is_none(),
        syn::Expr::Binary(it) => matches!(operator::written(&it.op), Some((_, true))),
        _ => false,
    }
}

/// Returns true for a number with the suffix of an integer of 128 bits; a slot has its type.
fn is_wide_literal(literal: &syn::Lit) -> bool {
    matches!(literal, syn::Lit::Int(it) if is_wide(it.suffix()))
}

/// Returns true for the name of an integer of 128 bits.
fn is_wide_type(ty: &syn::Type) -> bool {
    matches!(ty, syn::Type::Path(it) if it.path.get_ident().is_some_and(|it| is_wide(&text(it))))
}

/// Returns the digits of an integer, in hexadecimal if its author writes it in hexadecimal or binary.
fn digits(it: &syn::LitInt) -> String {
    let by_bits = it.token().to_string();
    let by_bits = by_bits.starts_with("0x") || by_bits.starts_with("0b");
    match it.base10_parse::<u128>() {
        Ok(value) if by_bits => format!("{value:#x}"),
        _ => it.base10_digits().into(),
    }
}
