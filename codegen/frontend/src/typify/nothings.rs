//! Zero-sized types of a package, and the fields that the C has beside them.
//!
//! Must not know: how an expression of such a type is lowered ([`zero_sized`](super::zero_sized)).

use bessemer_ir::tree::{self, Definition, Ty};
use bessemer_ir::{Field, FunctionId, StructId, Type};

use super::context::{Context, Nothing};
use super::{Result, refusals, refused};

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

/// Returns the index of the field with a name, or with the number of a part.
fn position(fields: &[Field], name: &str) -> Option<usize> {
    match name.parse::<usize>() {
        Ok(index) => (index < fields.len()).then_some(index),
        Err(_) => fields.iter().position(|field| field.name == name),
    }
}
