//! Zero-sized types: structs without fields, `PhantomData`, `()`. C has no such types, so they are omitted from
//! structs, variants, parameters and results. An expression of such a type is lowered for its effects.

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, ExprKind as Tree, NO_SLOT, Pattern, Site};
use bessemer_ir::{Expr, ExprKind, StmtKind, Type};

use super::lowering::Lowering;
use super::pattern::Test;
use super::value::Value;
use super::{Result, refusals, refused};

impl Lowering<'_, '_> {
    /// Returns true if rustc's type in a slot is zero-sized, or a reference to such a type.
    pub(super) fn slot_is_nothing(&self, slot: u32) -> bool {
        slot != NO_SLOT
            && self.source.slots.get(slot as usize).is_some_and(|ty| self.cx.is_nothing(ty))
    }

    /// Returns true if the value of an expression is zero-sized.
    pub(super) fn holds_nothing(&mut self, expr: &tree::Expr) -> bool {
        match &expr.kind {
            Tree::Local(name) => {
                matches!(self.lookup(name, expr.site), Ok(Value::Nothing))
            }
            Tree::Ref(_, inner) | Tree::Deref(inner) => self.holds_nothing(inner),
            Tree::Tuple(parts) if parts.is_empty() => true,
            Tree::Field(base, name) => {
                if !self.cx.types.leaves_out {
                    return false;
                }
                self.holds_nothing(base)
                    || match self.place_type(base) {
                        Ok(Type::Struct(id)) => self.cx.field_at(id, name) == Some(None),
                        _ => false,
                    }
            }
            _ => expr.slot.is_some_and(|slot| self.slot_is_nothing(slot)),
        }
    }

    /// Returns the value of every zero-sized type.
    pub(super) fn nothing(&mut self, site: Site) -> Expr {
        Expr::literal(0, Type::Unit, self.span(site))
    }

    /// Lowers the effects of an expression with a zero-sized value, and returns what remains to be emitted.
    pub(super) fn done(&mut self, expr: &tree::Expr) -> Result<Expr> {
        match &expr.kind {
            Tree::Local(_) | Tree::Path(..) => {}
            Tree::Ref(_, inner) | Tree::Deref(inner) => self.effect(inner)?,
            Tree::Field(base, _) if self.holds_nothing(base) => self.effect(base)?,
            // Its indices are looked at.
            Tree::Field(base, _) => _ = self.base(base)?,
            Tree::Struct(_, fields, rest) => {
                for (_, value) in fields {
                    self.effect(value)?;
                }
                rest.iter().try_for_each(|rest| self.effect(rest))?;
            }
            Tree::Constructor(_, parts) | Tree::Tuple(parts) => {
                parts.iter().try_for_each(|part| self.effect(part))?;
            }
            _ => return self.bare_value(expr, None),
        }
        Ok(self.nothing(expr.site))
    }

    /// Binds the names of a pattern to a zero-sized value, which every pattern matches.
    pub(super) fn take_nothing(pattern: &Pattern, site: Site) -> Test {
        let named = |name: &String| Test::named(name, NO_SLOT, Value::Nothing, site);
        pattern.bound().iter().map(named).fold(Test::default(), Test::with)
    }

    /// Refuses a local of a zero-sized type that was not removed.
    pub(super) fn check_locals(&self) -> Result<()> {
        match self.locals.iter().find(|local| local.ty == Type::Unit) {
            Some(local) => {
                refused(Site(local.span.line, local.span.column), refusals::KEPT_NOTHING)
            }
            None => Ok(()),
        }
    }

    /// Emits the remaining effects of a zero-sized value.
    pub(super) fn discard(&mut self, value: Expr) {
        let idle = match &value.kind {
            ExprKind::Literal(_) => true,
            // `Trapezoid::new()`.
            ExprKind::Call(id, arguments) => {
                arguments.is_empty() && self.cx.module.functions[id.index()].body.0.is_empty()
            }
            _ => false,
        };
        if !idle {
            let span = value.span;
            self.emit(StmtKind::Expr(value), span);
        }
    }
}
