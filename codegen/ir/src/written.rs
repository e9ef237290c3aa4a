//! Spelling of literals: the base or the name that their author wrote.
//!
//! Invariant: it affects only the appearance of the C. Every analysis sees the number.

use crate::{ConstId, EnumId, Expr, ExprKind, Module};

/// The author's spelling of a literal, other than in decimal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    /// In hexadecimal or binary (which C99 lacks).
    Hexadecimal,
    /// By the name of a constant; only for an index.
    Constant(ConstId),
    /// By the name of a variant, of which it is the number; only for an index.
    Variant(EnumId, u32),
}

impl Module {
    /// Returns the author's spelling of a literal, if what it names is there.
    pub fn written(&self, literal: &Expr) -> Option<Written> {
        let ExprKind::Literal(word) = literal.kind else { return None };
        let is_there = |written: &Written| match written {
            Written::Hexadecimal => true,
            Written::Constant(id) => id.index() < self.consts.len(),
            Written::Variant(id, at) => {
                let of = self.enums.get(id.index());
                of.is_some_and(|it| (*at as usize) < it.variants.len())
            }
        };
        self.written.get(&(literal.span, word)).copied().filter(is_there)
    }

    /// Returns the constant that an expression names, as its value or as an index.
    pub fn constant(&self, expr: &Expr) -> Option<ConstId> {
        match (&expr.kind, self.written(expr)) {
            (ExprKind::Const(id), _) => Some(*id),
            (_, Some(Written::Constant(id))) => Some(id),
            _ => None,
        }
    }
}
