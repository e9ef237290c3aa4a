//! Zero-sized types: structs without fields, `PhantomData`, `()`. C has no such types, so they are omitted from
//! structs, variants, parameters and results. An expression of such a type is lowered for its effects.

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, Definition, ExprKind as Tree, NO_SLOT, Pattern, Site, Ty};
use bessemer_ir::{Expr, ExprKind, FunctionId, StmtKind, StructId, Type};

use super::generic::position;
use super::lowering::Lowering;
use super::pattern::Test;
use super::value::Value;
use super::{Context, Result, refusals, refused};

/// An author's zero-sized type.
pub(super) struct Nothing {
    pub name: String,
    pub module: String,
    /// True if the type does not derive `PartialEq`, so its values may be unequal.
    unequal: bool,
}

impl Context<'_> {
    /// Defines a struct without fields in the C.
    pub(super) fn define_nothing(&mut self, definition: &Definition, name: String) -> Result<()> {
        let (site, kind) = (definition.site, &definition.kind);
        if let tree::DefinitionKind::Struct { initial: Some(_), .. } = kind {
            return refused(site, refusals::EMPTY_COMPONENT);
        }
        if definition.given.name.is_some() {
            return refused(site, refusals::EMPTY_NAME);
        }
        let (module, unequal) = (definition.module.clone(), !definition.equal);
        self.types.nothings.insert(definition.path.clone(), Nothing { name, module, unequal });
        self.types.leaves_out = true;
        self.types.by_path.insert(definition.path.clone(), Type::Unit);
        Ok(())
    }

    /// Returns the author's zero-sized type that a type is.
    pub(super) fn nothing_of(&self, ty: &Ty) -> Option<&Nothing> {
        match ty {
            Ty::Named(path) => self.types.nothings.get(path),
            _ => None,
        }
    }

    /// Returns true if a type is zero-sized and its values may be unequal.
    pub(super) fn may_differ(&self, ty: &Ty) -> bool {
        self.nothing_of(ty).is_some_and(|it| it.unequal)
    }

    /// Records the indices of the author's fields in the C, if some are zero-sized.
    pub(super) fn note_fields(&mut self, id: StructId, fields: &[tree::Field], kept: &[bool]) {
        let held = fields.iter().zip(kept).filter(|(_, kept)| **kept);
        let known = self.note(&Type::Struct(id));
        known.rustc = held.map(|(field, _)| field.ty.clone()).collect();
        if kept.iter().all(|kept| *kept) {
            return;
        }
        let mut next = 0..;
        let places = fields.iter().zip(kept).map(|(field, kept)| {
            (field.name.clone(), kept.then(|| next.next().unwrap_or_default()))
        });
        known.fields = places.collect();
        self.types.leaves_out = true;
    }

    /// Returns the index of the field with a name, or with the number of a part. None if a zero-sized field is absent
    /// from the C.
    pub(super) fn field_at(&self, id: StructId, name: &str) -> Option<Option<usize>> {
        match self.known_of(id).fields.as_slice() {
            [] => position(self.fields(id), name).map(Some),
            all => all.iter().find(|(known, _)| known == name).map(|(_, at)| *at),
        }
    }

    /// Returns the indices of the author's fields of a struct, in order.
    pub(super) fn fields_at(&self, id: StructId) -> Vec<Option<usize>> {
        match self.known_of(id).fields.as_slice() {
            [] => (0..self.fields(id).len()).map(Some).collect(),
            all => all.iter().map(|(_, at)| *at).collect(),
        }
    }

    /// Returns true if an argument, by its index among the author's, is zero-sized.
    pub(super) fn is_absent(&self, id: FunctionId, index: usize) -> bool {
        let absent = self.calls.absent.get(&id).and_then(|absent| absent.get(index));
        absent.copied().unwrap_or_default()
    }

    /// Returns true if a type, or the referent of a reference, is zero-sized.
    pub(super) fn is_nothing(&self, ty: &Ty) -> bool {
        match ty {
            Ty::Unit => true,
            Ty::Named(path) => self.types.nothings.contains_key(path),
            Ty::Ref(inner, _) | Ty::Known(_, inner) => self.is_nothing(inner),
            _ => false,
        }
    }
}

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
