//! The locals of the function being lowered, and the facts about each.
//!
//! Invariant: nothing writes a temporary, an atom or a counter after its declaration, except a counter's own loop.
//!
//! Must not know: how anything is lowered; in which order anything is evaluated.

use std::ops::{Deref, DerefMut};

use bessemer_ir::tree::Ty;
use bessemer_ir::{Local, LocalId, Mode, Place, Span, Type};

/// The locals of a function, by their handles.
#[derive(Default)]
pub(super) struct Locals {
    all: Vec<Local>,
    facts: Vec<Facts>,
}

/// Reasons why a local was declared.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum Origin {
    /// The author named it, or code of the compiler writes it.
    #[default]
    Variable,
    /// It has no name of the author's, and is not written again.
    Temporary,
    /// A temporary that [`fuse`](crate::fuse) may substitute.
    Atom,
    /// An atom that has the value of another place, under which a name of the author's denotes it.
    Copy,
    /// Only its loop changes it; or it is a parameter that nothing changes.
    Counter,
}

/// Facts about one local.
#[derive(Clone, Default)]
struct Facts {
    origin: Origin,
    /// Rustc's type, if the author may assign the local again.
    assigned: Option<Ty>,
    /// True if the local may remain unread: the beginning or length of a slice, or a name that only a guard uses.
    optional: bool,
    /// True if the declaration needs an initial value.
    valued: bool,
    /// True if only the name's first part says anything.
    unnamed: bool,
}

impl Locals {
    /// Adds a local.
    pub fn add(&mut self, local: Local) -> LocalId {
        self.all.push(local);
        self.facts.push(Facts::default());
        LocalId(self.all.len() as u32 - 1)
    }

    /// Adds a local by value.
    pub fn by_value(&mut self, name: String, ty: Type, span: Span) -> LocalId {
        self.add(Local { name, ty, mode: Mode::Value, span })
    }

    /// Returns the locals without the facts.
    pub fn into_all(self) -> Vec<Local> {
        self.all
    }

    fn facts(&mut self, local: LocalId) -> &mut Facts {
        &mut self.facts[local.index()]
    }

    /// Records that a local has no name of the author's, and is not written again.
    pub fn note_temporary(&mut self, local: LocalId) {
        let origin = &mut self.facts(local).origin;
        if *origin != Origin::Atom {
            *origin = Origin::Temporary;
        }
    }

    /// Records that a local is a temporary that may be substituted.
    pub fn note_atom(&mut self, local: LocalId) {
        self.facts(local).origin = Origin::Atom;
    }

    /// Records that a local is an atom with the value of another place.
    pub fn note_copy(&mut self, local: LocalId) {
        self.facts(local).origin = Origin::Copy;
    }

    /// Records that only its loop changes a local, or nothing.
    pub fn note_counter(&mut self, local: LocalId) {
        self.facts(local).origin = Origin::Counter;
    }

    /// Records that the author may assign a local again, with rustc's type.
    pub fn note_assigned(&mut self, local: LocalId, ty: Ty) {
        self.facts(local).assigned = Some(ty);
    }

    /// Records that a local may remain unread.
    pub fn note_optional(&mut self, local: LocalId) {
        self.facts(local).optional = true;
    }

    /// Records that the declaration of a local needs an initial value.
    pub fn note_valued(&mut self, local: LocalId) {
        self.facts(local).valued = true;
    }

    /// Records that nothing but its role has named a local yet.
    pub fn note_unnamed(&mut self, local: LocalId) {
        self.facts(local).unnamed = true;
    }

    /// Returns true if nothing but its role has named a local.
    pub fn is_unnamed(&self, local: LocalId) -> bool {
        self.facts[local.index()].unnamed
    }

    /// Keeps a temporary in the C, with a name of the author's.
    pub fn note_named(&mut self, local: LocalId) {
        self.facts(local).unnamed = false;
        let origin = &mut self.facts(local).origin;
        if *origin == Origin::Atom {
            *origin = Origin::Temporary;
        }
    }

    /// Makes a temporary the author's: it may be renamed and written. Returns true if it was a temporary.
    pub fn release(&mut self, local: LocalId) -> bool {
        let was = self.is_temporary(local);
        if was {
            self.facts(local).origin = Origin::Variable;
            self.facts(local).unnamed = false;
        }
        was
    }

    /// Makes a local a variable that is written from here on.
    pub fn note_written(&mut self, local: LocalId) {
        let facts = self.facts(local);
        facts.origin = Origin::Variable;
        facts.assigned.get_or_insert(Ty::Unit);
    }

    /// Returns true for a local without a name of the author's, which is not written again.
    pub fn is_temporary(&self, local: LocalId) -> bool {
        matches!(self.facts[local.index()].origin, Origin::Temporary | Origin::Atom)
    }

    /// Returns true for a temporary that may be substituted.
    pub fn is_atom(&self, local: LocalId) -> bool {
        matches!(self.facts[local.index()].origin, Origin::Atom | Origin::Copy)
    }

    /// Returns true if a place keeps its value.
    pub fn is_constant_place(&self, place: &Place) -> bool {
        self.lasts(place) || self.is_atom(place.root)
    }

    /// Returns true for an atom with the value of another place.
    pub fn is_copy(&self, local: LocalId) -> bool {
        self.facts[local.index()].origin == Origin::Copy
    }

    /// Returns true for a counter, or a parameter that nothing changes.
    pub fn is_counter(&self, local: LocalId) -> bool {
        self.facts[local.index()].origin == Origin::Counter
    }

    /// Returns true if nothing writes a place: it is behind `&`, in a temporary, or a counter.
    pub fn lasts(&self, place: &Place) -> bool {
        self.all[place.root.index()].mode == Mode::Ref
            || self.is_temporary(place.root)
            || place.steps.is_empty() && self.is_counter(place.root)
    }

    /// Returns rustc's type of a local that the author may assign again.
    pub fn assigned(&self, local: LocalId) -> Option<&Ty> {
        self.facts[local.index()].assigned.as_ref()
    }

    /// Returns true if the author may write a local again, or its caller's variable through it.
    pub fn may_change(&self, local: LocalId) -> bool {
        self.assigned(local).is_some() || self.all[local.index()].mode == Mode::RefMut
    }

    /// Returns true for a local that may remain unread.
    pub fn is_optional(&self, local: LocalId) -> bool {
        self.facts[local.index()].optional
    }

    /// Returns true for a local whose declaration needs an initial value.
    pub fn is_valued(&self, local: LocalId) -> bool {
        self.facts[local.index()].valued
    }
}

impl Deref for Locals {
    type Target = [Local];

    fn deref(&self) -> &[Local] {
        &self.all
    }
}

impl DerefMut for Locals {
    fn deref_mut(&mut self) -> &mut [Local] {
        &mut self.all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one() -> (Locals, LocalId) {
        let mut locals = Locals::default();
        let (name, ty, span) = (String::new(), Type::BOOL, Span::default());
        let local = locals.add(Local { name, ty, mode: Mode::Value, span });
        (locals, local)
    }

    #[test]
    fn a_local_has_one_origin() {
        let (mut locals, local) = one();
        assert!(!locals.is_temporary(local) && !locals.release(local));
        locals.note_atom(local);
        locals.note_temporary(local);
        assert!(locals.is_atom(local) && locals.is_temporary(local));
        locals.note_named(local);
        assert!(!locals.is_atom(local) && locals.is_temporary(local));
        assert!(locals.release(local));
        locals.note_counter(local);
        locals.note_named(local);
        assert!(locals.is_counter(local) && !locals.release(local) && locals.is_counter(local));
        locals.note_written(local);
        assert!(!locals.is_counter(local));
        assert_eq!(locals.assigned(local), Some(&Ty::Unit));
    }

    #[test]
    fn a_part_of_a_counter_may_change() {
        let (mut locals, local) = one();
        let place = Place::local(local, Type::BOOL, Span::default());
        assert!(!locals.lasts(&place));
        locals.note_counter(local);
        let part = place.inside(bessemer_ir::Step::Field(0), Type::BOOL);
        assert!(locals.lasts(&place) && !locals.lasts(&part));
        locals.note_temporary(local);
        assert!(locals.lasts(&place) && locals.lasts(&part));
        assert!(locals.is_constant_place(&place));
    }

    #[test]
    fn a_copy_may_go_and_does_not_name() {
        let (mut locals, local) = one();
        let place = Place::local(local, Type::BOOL, Span::default());
        locals.note_copy(local);
        assert!(locals.is_atom(local) && locals.is_constant_place(&place));
        assert!(!locals.lasts(&place) && !locals.is_temporary(local));
    }
}
