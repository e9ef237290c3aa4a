//! The function or operation that a call names.
//!
//! Must not know: how a call is lowered.

use bessemer_ir::tree::{self, Builtin};

use super::context::Context;
use super::lowering::Lowering;

/// First number of callees that have no name in the source: `next` and `iter` of author-defined iterators.
const CALLEES: u32 = 1 << 31;

/// A function and the arguments of a call.
pub(super) type Called<'a, 't> = (&'a tree::Function, &'t [tree::Expr]);

impl Context<'_> {
    /// Returns the number of a callee that has no name in the source.
    pub(super) fn unnamed(&mut self, path: &str) -> u32 {
        let is_it =
            |it: &tree::Callee| matches!(it, tree::Callee::Function(known) if known == path);
        let known = self.calls.unnamed.iter().position(is_it).unwrap_or_else(|| {
            self.calls.unnamed.push(tree::Callee::Function(path.to_owned()));
            self.calls.unnamed.len() - 1
        });
        CALLEES + known as u32
    }

    /// Returns the callee with such a number.
    pub(super) fn unnamed_callee(&self, number: u32) -> Option<&tree::Callee> {
        self.calls.unnamed.get(number.checked_sub(CALLEES)? as usize)
    }
}

impl<'a> Lowering<'a, '_> {
    /// Returns the callee with a number.
    pub(super) fn callee(&self, number: u32) -> Option<&tree::Callee> {
        let named = self.source.callees.get(number as usize);
        named.or_else(|| self.cx.unnamed_callee(number))
    }

    /// Returns the built-in operation that a callee is; none for a function.
    pub(super) fn builtin_of(&self, callee: u32) -> Option<Builtin> {
        match self.callee(callee)? {
            tree::Callee::Builtin(builtin) => Some(*builtin),
            tree::Callee::Function(_) => None,
        }
    }

    /// Returns the built-in operation that an expression calls, and its arguments.
    pub(super) fn builtin_call<'t>(
        &self,
        expr: &'t tree::Expr,
    ) -> Option<(Builtin, &'t [tree::Expr])> {
        let tree::ExprKind::Call(callee, arguments) = &expr.kind else { return None };
        Some((self.builtin_of(*callee)?, arguments))
    }

    /// Returns the function that an expression calls, and its arguments.
    pub(super) fn called<'t>(&self, expr: &'t tree::Expr) -> Option<Called<'a, 't>> {
        let tree::ExprKind::Call(callee, arguments) = &expr.kind else { return None };
        match self.callee(*callee)? {
            tree::Callee::Function(path) => {
                Some((self.cx.calls.all.get(path.as_str())?, arguments))
            }
            tree::Callee::Builtin(_) => None,
        }
    }
}
