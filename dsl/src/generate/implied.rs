//! Items of generic types' instances that are called other than by name: `[…]`, `==`, and the author's own `next` and
//! `iter`.
//!
//! The link-time registry has those of types that are not generic. An instance says what it has wherever it is built; the
//! functions are built when all else is.

use core::any::type_name;

use bessemer_tree as tree;

use super::builder::{Builder, OwnOperator};
use super::operators::sign;
use super::own::Asked;
use super::slot::{DslType, Slot};

/// Trait by which each instance of a generic type registers the items that are called other than by name, wherever its
/// methods are built.
pub trait OwnImplied<O> {
    /// Notes the function for this instance.
    fn note(cx: &mut Builder);
}

macro_rules! implied {
    ($($of:ident: $note:ident;)*) => {
        $(
            impl<T: OwnImplied<sign::$of>> Asked<T> {
                /// Notes its own, if it has one.
                pub fn $note(&self, cx: &mut Builder) {
                    T::note(cx);
                }
            }
        )*

        /// The answers for a type without.
        pub trait NotImplied {
            $(
                /// There is none.
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

/// Asks a type for all of these, where its bounds are known.
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

/// Asks the type in a slot.
pub fn __asked<T>(_: &Slot<T>) -> Asked<T> {
    Asked::of()
}

impl Builder {
    /// Registers an item of an instance that is called other than by name. It is built last, since its function may
    /// call one that is being built.
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
