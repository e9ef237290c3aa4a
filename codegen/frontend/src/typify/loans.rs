//! Values that contain a copy of their referent. If nothing else can write the place during the borrow, a `&T` in a
//! tuple, an `Option`, a struct or an array is a `T` in the C. A name bound to such a value must keep it when the
//! author assigns the reference again, so it is copied from a variable that may be assigned.
//!
//! Invariant: the copy is never written, since only a shared reference is represented by one.

use bessemer_ir::tree::Ty;
use bessemer_ir::{LocalId, Mode, Place, Step, StructId, Type};

use super::context::{Case, Context};
use super::lowering::Lowering;

impl Context<'_> {
    /// Returns rustc's type of the part to which a step leads, from rustc's type of the whole.
    fn rustc_behind(&self, step: &Step, at: &Type, ty: Option<&Ty>) -> Option<Ty> {
        match (step, at, ty) {
            (step, _, Some(Ty::Known(_, inner) | Ty::Ref(inner, _))) => {
                self.rustc_behind(step, at, Some(inner))
            }
            (Step::Field(field), Type::Struct(id), ty) => self.rustc_field(*id, *field, ty),
            (Step::From(_), _, ty) => ty.cloned(),
            (_, _, Some(Ty::Array(element, _) | Ty::Slice(element))) => Some((**element).clone()),
            _ => None,
        }
    }

    fn rustc_field(&self, id: StructId, field: u32, ty: Option<&Ty>) -> Option<Ty> {
        let variant = |case: &Case| case.field == Some(field);
        match ty {
            Some(Ty::Tuple(parts)) => {
                let at = |it: &Option<usize>| *it == Some(field as usize);
                parts.get(self.fields_at(id).iter().position(at)?).cloned()
            }
            Some(Ty::List(element, n)) => Some(Ty::Array(element.clone(), *n)),
            Some(Ty::Option(value)) => (field > 0).then(|| (**value).clone()),
            Some(Ty::Result(value, error)) => {
                let case = self.known_of(id).cases.iter().find(|case| variant(case))?;
                Some((**if case.name == "Ok" { value } else { error }).clone())
            }
            _ => self.known_of(id).rustc.get(field as usize).cloned(),
        }
    }
}

impl Lowering<'_, '_> {
    /// Records that the author may assign a local again, with rustc's type from its slot.
    pub(super) fn note_changing(&mut self, local: LocalId, slot: u32) {
        let ty = self.source.slots.get(slot as usize).cloned();
        self.locals.note_assigned(local, ty.unwrap_or(Ty::Unit));
    }

    /// Returns rustc's types along a place, beginning with its local; none where unknown.
    fn rustc_along(&self, place: &Place) -> Vec<Option<Ty>> {
        let first = match self.locals.assigned(place.root) {
            // What a parameter refers to.
            Some(Ty::Ref(inner, true)) => Some((**inner).clone()),
            ty => ty.cloned(),
        };
        let mut along = vec![first];
        for (at, step) in place.steps.iter().enumerate() {
            let before = self.type_of(place.root, &place.steps[..at]);
            along.push(self.cx.rustc_behind(step, &before, along[at].as_ref()));
        }
        along
    }

    /// Returns rustc's type of a place that its author may assign again.
    pub(super) fn rustc_at(&self, place: &Place) -> Option<Ty> {
        self.locals.assigned(place.root)?;
        self.rustc_along(place).pop()?
    }

    /// Returns true if a place holds a copy of a referenced value, and the reference may be assigned again.
    pub(super) fn is_loan(&self, place: &Place) -> bool {
        let changes = self.locals.assigned(place.root).is_some()
            || self.locals[place.root.index()].mode == Mode::RefMut
            || self.lenders.has_placeholder(place.root);
        let refers = |ty: &Option<Ty>| matches!(ty, Some(Ty::Ref(_, false)));
        changes && self.rustc_along(place).iter().any(refers)
    }
}
