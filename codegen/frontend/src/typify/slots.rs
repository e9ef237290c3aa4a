//! rustc's types in the slots of a function, and the spans of its nodes.
//!
//! Must not know: the types that the lowering computes.

use bessemer_ir::tree::{self, Site, Ty};
use bessemer_ir::{Span, Type};

use super::lowering::Lowering;
use super::problem::{Needed, Result};
use super::syntax::is_of_library;

/// Returns the result type of a function, as rustc inferred it.
pub(super) fn result_of(function: &tree::Function) -> Option<&Ty> {
    function.slots.get(function.tree.result as usize)
}

/// Returns the element type of the slice that a type refers to.
pub(super) fn slice_of(ty: &Ty) -> Option<&Ty> {
    match ty {
        Ty::Ref(inner, _) => match &**inner {
            Ty::Slice(element) => Some(element),
            _ => None,
        },
        _ => None,
    }
}

/// Returns rustc's type in a slot.
pub(super) fn slot_type(source: &tree::Function, slot: u32, site: Site) -> Result<&Ty> {
    source.slots.get(slot as usize).needed(site, "the tree names a slot that is not there")
}

impl Lowering<'_, '_> {
    /// Returns the place of a node; of the DSL's own code that is inlined, the place of the author's call.
    pub(super) fn span(&mut self, site: Site) -> Span {
        match self.expanding.last() {
            Some((_, call)) if is_of_library(self.source) => *call,
            _ => self.cx.span(&self.source.file, site),
        }
    }

    /// Returns the type in a slot as a value type.
    pub(super) fn slot(&mut self, slot: u32, site: Site) -> Result<Type> {
        self.cx.value_type(slot_type(self.source, slot, site)?, site)
    }

    /// Returns the type in a slot of an expression that is read; for a reference it is the referent's type.
    pub(super) fn seen(&mut self, slot: u32, site: Site) -> Result<Type> {
        match slot_type(self.source, slot, site)? {
            Ty::Ref(inner, false) => self.cx.pointee(inner, site),
            ty => self.cx.content_type(ty, site),
        }
    }

    /// Returns the type of an expression as rustc inferred it; none if it has no slot.
    pub(super) fn seen_as(&self, expr: &tree::Expr) -> Option<&Ty> {
        self.source.slots.get(expr.slot? as usize)
    }

    /// Returns the referent of the reference type in a slot.
    pub(super) fn refers_to(&mut self, slot: u32, site: Site) -> Result<Type> {
        self.cx.pointee(slot_type(self.source, slot, site)?, site)
    }

    pub(super) fn slot_is_slice(&self, slot: u32, site: Site) -> Result<bool> {
        Ok(slice_of(slot_type(self.source, slot, site)?).is_some())
    }

    pub(super) fn slot_is_reference(&self, slot: u32, site: Site) -> Result<bool> {
        Ok(matches!(slot_type(self.source, slot, site)?, Ty::Ref(..)))
    }

    pub(super) fn slot_is_exclusive(&self, slot: u32, site: Site) -> Result<bool> {
        Ok(matches!(slot_type(self.source, slot, site)?, Ty::Ref(_, true)))
    }
}
