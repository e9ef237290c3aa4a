//! Implicit behaviour of Rust's types that an author may have replaced: copies, order, drops, borrows.
//!
//! The C copies and compares part by part, and does nothing where a value's life ends.

use alloc::format;
use alloc::string::String;
use core::marker::PhantomData;
use core::mem::needs_drop;
use core::ops::Deref;

/// Traits that an author implemented by hand for a type, where the DSL expects a derived one.
pub struct Own {
    /// `Clone` is implemented.
    pub clone: bool,
    /// `Ord` is implemented, beside a derived `PartialOrd`.
    pub order: bool,
    /// `Drop` is implemented, for the type or for a part.
    pub drop: bool,
    /// `Deref` is implemented.
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
        ];
        told.into_iter().filter(|it| it.0).map(|(_, message, remedy)| (message, remedy))
    }
}

/// Query for the traits of a type. If it has one, an inherent method answers, which Rust prefers to the trait method
/// of [`NotImplemented`].
pub struct Asked<T>(PhantomData<T>);

impl<T> Asked<T> {
    /// Returns the query.
    pub fn of() -> Asked<T> {
        Asked(PhantomData)
    }

    /// Returns true if dropping a value has an effect.
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

/// Answers for a type without the trait.
pub trait NotImplemented {
    /// Returns false: no `Clone`.
    fn clones(&self) -> bool {
        false
    }
    /// Returns false: no `Copy`.
    fn copies(&self) -> bool {
        false
    }
    /// Returns false: no `Ord`.
    fn orders(&self) -> bool {
        false
    }
    /// Returns false: no `Deref`.
    fn lends(&self) -> bool {
        false
    }
}

impl<T> NotImplemented for Asked<T> {}
