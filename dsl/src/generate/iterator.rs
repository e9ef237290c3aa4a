//! Iterators that authors' functions give or take: nothing in the C, where what goes through them stands in the loop that
//! gives them.

#![allow(missing_docs)]

use core::cmp::Ordering;
use core::marker::PhantomData;

use bessemer_ir::tree::{self, Desugared, Together, Ty};

use super::builder::{Builder, Callee};
use super::builtin::{markers, signatures};
use super::option;
use super::slot::{Called, Companion, DslType, Exclusive, Seen, Shared, Value};
use crate::Plain;
use crate::iterate;

/// What the companion of a function gives that gives an iterator of `T`, and what the builder of one that takes it has.
pub struct Items<T>(PhantomData<T>);

impl<T> Clone for Items<T> {
    fn clone(&self) -> Self {
        Items(PhantomData)
    }
}

#[allow(clippy::unused_self)]
impl<T> Items<T> {
    pub fn __b_clone(&self) -> Called<option::AsRef, Self> {
        unreachable!("a witness copy is never run")
    }
}

impl<T> Iterator for Items<T> {
    type Item = T;
    fn next(&mut self) -> Option<T> {
        unreachable!("a witness copy is never run")
    }
}

impl<T> DoubleEndedIterator for Items<T> {
    fn next_back(&mut self) -> Option<T> {
        unreachable!("a witness copy is never run")
    }
}

impl<T> ExactSizeIterator for Items<T> {}

/// `items.collect()`, `Inputs::from_iter(items)`: the function of an author's that gathers items of type `A`.
#[diagnostic::on_unimplemented(
    message = "nothing of the DSL gathers items of type `{A}` in a `{Self}`",
    label = "does not gather these",
    note = "an `impl FromIterator<{A}> for` a type of the author's own is marked `#[data]`; a `List` takes them by `extend`"
)]
pub trait FromIteratorBuiltin<A>: Sized {
    /// Which function it is.
    type Marker;
    fn __b_from_iter<I: IntoIterator<Item = A>>(_items: I) -> Called<Self::Marker, Self> {
        unreachable!()
    }
}

/// `gathered.extend(items)`: the function of an author's that takes items of type `A` into what is there.
pub trait ExtendBuiltin<A> {
    /// Which function it is.
    type Marker;
    fn __b_extend<I: IntoIterator<Item = A>>(&mut self, _items: I) -> Called<Self::Marker, ()> {
        unreachable!()
    }
}

impl<T> DslType for Items<T> {
    fn ty(_: &mut Builder) -> Ty {
        Ty::Unit
    }
}

impl<T: Seen> Seen for Items<T> {
    type Slot = Items<T::Slot>;
}

impl<T> Plain for Items<T> {
    const WORDS: usize = 0;
    fn store(&self, _: &mut dyn FnMut(u64)) {}
    fn load(_: &mut dyn FnMut() -> u64) -> Self {
        unreachable!("a witness copy is never run")
    }
}

/// A reference is a value where a function stands in place: it is what it refers to.
macro_rules! references {
    ($($reference:ident)*) => {$(
        impl<T: ?Sized> Seen for $reference<T> {
            type Slot = $reference<T>;
        }

        impl<T: ?Sized> PartialEq for $reference<T> {
            fn eq(&self, _: &Self) -> bool {
                unreachable!("a witness copy is never run")
            }
        }

        impl<T: ?Sized> PartialOrd for $reference<T> {
            fn partial_cmp(&self, _: &Self) -> Option<Ordering> {
                unreachable!("a witness copy is never run")
            }
        }

        impl<T: ?Sized> Plain for $reference<T> {
            const WORDS: usize = 0;
            fn store(&self, _: &mut dyn FnMut(u64)) {}
            fn load(_: &mut dyn FnMut() -> u64) -> Self {
                unreachable!("a witness copy is never run")
            }
        }
    )*};
}

references! { Shared Exclusive }

/// The type of an item in a slot.
pub(super) type Item<I> = <<I as Iterator>::Item as Seen>::Slot;

/// The marker of a function that takes an iterator, by what it is generic over.
macro_rules! takes_items {
    ($module:ident: $(
        $marker:ident<$($of:ident $(: $bound:path)?),+>: $function:ident($($parameter:ty),*);
    )*) => {$(
        #[doc = concat!("The marker of `", stringify!($function), "`.")]
        pub struct $marker<$($of),+>(PhantomData<($($of,)+)>);
        impl<$($of: Value $(+ $bound)?),+> Callee for $marker<$($of),+> {
            fn callee(cx: &mut Builder) -> tree::Callee {
                let function = $module::$function::__call as fn($($parameter),*) -> _;
                Companion::callee(function, cx)
            }
        }
    )*};
}
pub(super) use takes_items;

takes_items! { iterate:
    Count<T>: count(Items<T>);
    Fold<T, A>: fold(Items<T>, A, fn(A, T) -> A);
    Any<T>: any(Items<T>, fn(T) -> bool);
    All<T>: all(Items<T>, fn(T) -> bool);
    Find<T>: find(Items<T>, fn(&T) -> bool);
    FindMap<T, U>: find_map(Items<T>, fn(T) -> Option<U>);
    Last<T>: last(Items<T>);
    Next<T>: next(Items<T>);
    Nth<T>: nth(Items<T>, usize);
    Position<T>: position(Items<T>, fn(T) -> bool);
    Rposition<T>: rposition(Items<T>, fn(T) -> bool);
    Max<T: PartialOrd>: max(Items<T>);
    Min<T: PartialOrd>: min(Items<T>);
    MaxBy<T>: max_by(Items<T>, fn(&T, &T) -> Ordering);
    MinBy<T>: min_by(Items<T>, fn(&T, &T) -> Ordering);
    MaxByKey<T, K: PartialOrd>: max_by_key(Items<T>, fn(&T) -> K);
    MinByKey<T, K: PartialOrd>: min_by_key(Items<T>, fn(&T) -> K);
    Cmp<T: PartialOrd>: cmp(Items<T>, Items<T>);
    Lt<T: PartialOrd<U>, U>: lt(Items<T>, Items<U>);
    Le<T: PartialOrd<U>, U>: le(Items<T>, Items<U>);
    Gt<T: PartialOrd<U>, U>: gt(Items<T>, Items<U>);
    Ge<T: PartialOrd<U>, U>: ge(Items<T>, Items<U>);
    Eq<T: PartialEq<U>, U>: eq(Items<T>, Items<U>);
    Ne<T: PartialEq<U>, U>: ne(Items<T>, Items<U>);
    ForEach<T>: for_each(Items<T>, fn(T));
    Reduce<T>: reduce(Items<T>, fn(T, T) -> T);
}

markers! {
    Sum: Desugared(Desugared::Together(Together::Sum));
    Product: Desugared(Desugared::Together(Together::Product));
    TryFold: Desugared(Desugared::Together(Together::Tried));
    ByRef: Desugared(Desugared::ByRef);
}

/// What a `try_fold` gives.
pub trait Tried<A> {}

impl<A> Tried<A> for Option<A> {}
impl<A, E> Tried<A> for Result<A, E> {}

/// Companions of methods of iterators, by their markers and by what they give, which are asked for their types alone.
macro_rules! of_iterators {
    (
        $(#[$doc:meta])*
        $trait:ident {$(
            $name:ident $([$($g:ident: $bound:path),+])? ($($parameter:ty),*)
                -> $marker:ty, $result:ty $(where $of:ty: $($such:path),+)?;
        )*}
    ) => {
        $(#[$doc])*
        pub trait $trait: Iterator<Item: Seen> + Sized {$(
            fn $name $(<$($g: $bound),+>)? (self, $(_: $parameter),*) -> Called<$marker, $result>
            $(where $of: $($such +)+)?
            {
                unreachable!("a witness copy is never run")
            }
        )*}

        impl<I: Iterator<Item: Seen>> $trait for I {}
    };
}
pub(super) use of_iterators;

of_iterators! {
    /// What iterators end in.
    Ends {
        __b_sum[S: core::iter::Sum<Self::Item>]() -> Sum, S;
        __b_product[P: core::iter::Product<Self::Item>]() -> Product, P;
        __b_for_each[F: FnMut(Self::Item)](F) -> ForEach<Item<Self>>, ();
        __b_reduce[F: FnMut(Self::Item, Self::Item) -> Self::Item](F)
            -> Reduce<Item<Self>>, Option<Self::Item>;
        __b_nth(usize) -> Nth<Item<Self>>, Option<Self::Item>;
        __b_position[F: FnMut(Self::Item) -> bool](F) -> Position<Item<Self>>, Option<usize>;
        __b_rposition[F: FnMut(Self::Item) -> bool](F) -> Rposition<Item<Self>>, Option<usize>
            where Self: DoubleEndedIterator, ExactSizeIterator;
        __b_max() -> Max<Item<Self>>, Option<Self::Item> where Self::Item: Ord;
        __b_min() -> Min<Item<Self>>, Option<Self::Item> where Self::Item: Ord;
        __b_count() -> Count<Item<Self>>, usize;
        __b_fold[A: Seen, F: FnMut(A, Self::Item) -> A](A, F) -> Fold<Item<Self>, A::Slot>, A;
        __b_try_fold[A: Sized, R: Tried<A>, F: FnMut(A, Self::Item) -> R](A, F) -> TryFold, R;
        __b_any[F: FnMut(Self::Item) -> bool](F) -> Any<Item<Self>>, bool;
        __b_all[F: FnMut(Self::Item) -> bool](F) -> All<Item<Self>>, bool;
        __b_find[F: FnMut(&Self::Item) -> bool](F) -> Find<Item<Self>>, Option<Self::Item>;
        __b_find_map[U: Seen, F: FnMut(Self::Item) -> Option<U>](F)
            -> FindMap<Item<Self>, U::Slot>, Option<U>;
        __b_max_by[F: FnMut(&Self::Item, &Self::Item) -> Ordering](F)
            -> MaxBy<Item<Self>>, Option<Self::Item>;
        __b_min_by[F: FnMut(&Self::Item, &Self::Item) -> Ordering](F)
            -> MinBy<Item<Self>>, Option<Self::Item>;
        __b_max_by_key[K: Seen, F: FnMut(&Self::Item) -> K](F)
            -> MaxByKey<Item<Self>, K::Slot>, Option<Self::Item> where K: Ord;
        __b_min_by_key[K: Seen, F: FnMut(&Self::Item) -> K](F)
            -> MinByKey<Item<Self>, K::Slot>, Option<Self::Item> where K: Ord;
        __b_cmp[I: IntoIterator<Item = Self::Item>](I) -> Cmp<Item<Self>>, Ordering
            where Self::Item: Ord;
        __b_lt[U: Seen, I: IntoIterator<Item = U>](I) -> Lt<Item<Self>, U::Slot>, bool
            where Self::Item: PartialOrd<U>;
        __b_le[U: Seen, I: IntoIterator<Item = U>](I) -> Le<Item<Self>, U::Slot>, bool
            where Self::Item: PartialOrd<U>;
        __b_gt[U: Seen, I: IntoIterator<Item = U>](I) -> Gt<Item<Self>, U::Slot>, bool
            where Self::Item: PartialOrd<U>;
        __b_ge[U: Seen, I: IntoIterator<Item = U>](I) -> Ge<Item<Self>, U::Slot>, bool
            where Self::Item: PartialOrd<U>;
        __b_eq[U: Seen, I: IntoIterator<Item = U>](I) -> Eq<Item<Self>, U::Slot>, bool
            where Self::Item: PartialEq<U>;
        __b_ne[U: Seen, I: IntoIterator<Item = U>](I) -> Ne<Item<Self>, U::Slot>, bool
            where Self::Item: PartialEq<U>;
        __b_last() -> Last<Item<Self>>, Option<Self::Item>;
        __b_next() -> Next<Item<Self>>, Option<Self::Item>;
    }
}

/// What lends an iterator that is gone through by hand.
#[allow(missing_docs)]
pub trait ByHand: Iterator<Item: Seen> + Sized {
    signatures! { fn __b_by_ref(&mut self) -> Called<ByRef, Items<Self::Item>>; }
}

impl<I: Iterator<Item: Seen>> ByHand for I {}
