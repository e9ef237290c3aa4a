//! Implicit behaviour of Rust's types that an author may have replaced: copies, the order of values, drops, borrows.
//!
//! The C copies and compares part by part, and does nothing where a value ends.

use alloc::format;
use alloc::string::String;
use core::marker::PhantomData;
use core::mem::needs_drop;
use core::ops::Deref;

/// Such implementations by an author for a type, if they are not derived where the DSL sees it.
pub struct Own {
    /// `Clone`.
    pub clone: bool,
    /// `Ord`, beside a `PartialOrd` that is derived.
    pub order: bool,
    /// `Drop`, of the type or of a part.
    pub drop: bool,
    /// `Deref`.
    pub lends: bool,
}

impl Own {
    /// Returns the diagnostics for a type, with remedies.
    pub(super) fn told(&self, name: &str) -> impl Iterator<Item = (String, &'static str)> + use<> {
        let derived = |of: &str| format!("`{name}` has no `#[derive({of})]` below `#[data]`");
        let told = [
            (
                self.clone,
                derived("Clone"),
                "write `#[derive(Clone)]` below `#[data]`: C copies all parts; write a method with another name for any other copy",
            ),
            (
                self.order,
                derived("Ord"),
                "write `#[derive(Ord)]` below `#[data]`, beside `PartialOrd`; or write a method, \
                 `fn is_before(&self, other: &Self) -> bool`",
            ),
            (
                self.drop,
                format!("`{name}` implements `Drop`, which C would never call"),
                "write a method, and call it at the end of the value's life",
            ),
            (
                self.lends,
                format!("`{name}` implements `Deref`, which hides the access that C has to name"),
                "write a method that returns the reference, `fn inner(&self) -> &Inner`",
            ),
        ];
        told.into_iter().filter(|it| it.0).map(|(_, message, remedy)| (message, remedy))
    }
}

/// Asks whether a type has a trait: a method of [`Asked`] itself answers for one that has, which Rust prefers to that of
/// [`NotImplemented`].
pub struct Asked<T>(PhantomData<T>);

impl<T> Asked<T> {
    /// The question.
    pub fn of() -> Asked<T> {
        Asked(PhantomData)
    }

    /// Returns true if something is done where a value of it ends.
    pub fn drops(&self) -> bool {
        needs_drop::<T>()
    }
}

impl<T: Clone> Asked<T> {
    /// Returns true if it has `Clone`.
    pub fn clones(&self) -> bool {
        true
    }
}

impl<T: Copy> Asked<T> {
    /// Returns true if it has `Copy`.
    pub fn copies(&self) -> bool {
        true
    }
}

impl<T: Ord> Asked<T> {
    /// Returns true if it has `Ord`.
    pub fn orders(&self) -> bool {
        true
    }
}

impl<T: Deref> Asked<T> {
    /// Returns true if it has `Deref`.
    pub fn lends(&self) -> bool {
        true
    }
}

/// The answers for a type without.
pub trait NotImplemented {
    /// It has no `Clone`.
    fn clones(&self) -> bool {
        false
    }
    /// It has no `Copy`.
    fn copies(&self) -> bool {
        false
    }
    /// It has no `Ord`.
    fn orders(&self) -> bool {
        false
    }
    /// It has no `Deref`.
    fn lends(&self) -> bool {
        false
    }
}

impl<T> NotImplemented for Asked<T> {}
