//! Functions of generic types' instances that have no call in the source: `Index`, `==`, and an author's `next` and
//! `iter`.
//!
//! The link-time registry has the functions of non-generic types. An instance is queried wherever it is built; its
//! functions are built after all others.

use core::any::type_name;

use bessemer_tree as tree;

use super::builder::{Builder, OwnOperator};
use super::operators::sign;
use super::own::Asked;
use super::slot::{DslType, Slot};

/// Trait with which each instance of a generic type registers such functions, wherever its methods are built.
pub trait OwnImplied<O> {
    /// Records the function for this instance.
    fn note(cx: &mut Builder);
}

macro_rules! implied {
    ($($of:ident: $note:ident;)*) => {
        $(
            impl<T: OwnImplied<sign::$of>> Asked<T> {
                /// Records the instance's function, if it has one.
                pub fn $note(&self, cx: &mut Builder) {
                    T::note(cx);
                }
            }
        )*

        /// Answer for a type without such a function.
        pub trait NotImplied {
            $(
                /// Does nothing.
                fn $note(&self, _: &mut Builder) {}
            )*
        }

        impl<T> NotImplied for Asked<T> {}
    };
}

implied! {
    Index: note_index;
    IndexMut: note_index_mut;
    PartialEq: note_equality;
    Iterator: note_iterator;
    Iter: note_iter;
    IterMut: note_iter_mut;
}

/// Queries a type for all of these functions, where its bounds are known.
#[macro_export]
#[doc(hidden)]
macro_rules! __note_implied {
    ($asked:expr, $cx:expr) => {
        #[allow(unused_imports)]
        use $crate::generate::NotImplied as _;
        let asked = $asked;
        asked.note_index($cx);
        asked.note_index_mut($cx);
        asked.note_equality($cx);
        asked.note_iterator($cx);
        asked.note_iter($cx);
        asked.note_iter_mut($cx);
    };
}
pub use __note_implied as note_implied;

/// Returns the query for the type in a slot.
pub fn __asked<T>(_: &Slot<T>) -> Asked<T> {
    Asked::of()
}

impl Builder {
    /// Registers a function without a call in the source for an instance. It is built last, since it may call a
    /// function that is being built.
    pub fn implied<Owner: DslType, Other: DslType>(
        &mut self,
        name: &'static str,
        build: fn(&mut Builder) -> tree::Callee,
    ) {
        let key = [name, type_name::<Owner>(), type_name::<Other>()];
        if self.known.insert(key.join(" ")) {
            self.untold.insert(key, OwnOperator { name, left: Owner::ty, right: Other::ty, build });
        }
    }
}
