//! Values that hold a copy of what they refer to. Where nothing else can write to the place during the borrow, a `&T`
//! in a tuple, an `Option`, a struct or an array is a `T` in the C. A name of it must keep its value when the reference
//! is assigned again, so it is copied out of a variable that its author may assign.
//!
//! Invariant: what is copied is read and never written, since only a shared reference is a copy.

use bessemer_ir::tree::Ty;
use bessemer_ir::{LocalId, Mode, Place, Step, StructId, Type};

use super::lowering::Lowering;
use super::{Context, generic};

impl Context<'_> {
    /// The type of what a step leads to, as rustc sees it, from that of what it begins at.
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
        let variant = |case: &generic::Case| case.field == Some(field);
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
    /// Notes that its author may write a local again, of which rustc put the type into a slot.
    pub(super) fn note_changing(&mut self, local: LocalId, slot: u32) {
        let ty = self.source.slots.get(slot as usize).cloned();
        self.changing.insert(local, ty.unwrap_or(Ty::Unit));
    }

    /// The types on the way to a place as rustc sees them, that of its local first, where they are known.
    fn rustc_along(&self, place: &Place) -> Vec<Option<Ty>> {
        let first = match self.changing.get(&place.root) {
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

    /// The type of what is at a place that its author may write again, as rustc sees it.
    pub(super) fn rustc_at(&self, place: &Place) -> Option<Ty> {
        self.changing.get(&place.root)?;
        self.rustc_along(place).pop()?
    }

    /// Returns true if a place holds a copy of a referenced value, and the reference may be assigned again.
    pub(super) fn is_loan(&self, place: &Place) -> bool {
        let changes = self.changing.contains_key(&place.root)
            || self.locals[place.root.index()].mode == Mode::RefMut
            || self.stands(place.root);
        let refers = |ty: &Option<Ty>| matches!(ty, Some(Ty::Ref(_, false)));
        changes && self.rustc_along(place).iter().any(refers)
    }
}
