//! Iterators that authors' functions return or take. They do not exist in the C, since the consumer's body is in the
//! iterator's loop.

#![allow(missing_docs)]

use core::cmp::Ordering;
use core::marker::PhantomData;

use bessemer_tree as tree;
use bessemer_tree::{Desugared, Together, Ty};

use super::builder::{Builder, Callee};
use super::companions::{calls, companions};
use super::containers;
use super::slot::{Called, DslType, Exclusive, Seen, Shared, Slot, dsl_types, never_held};
use crate::{List, adapt, iterate};

/// Result of the companion of a function that returns an iterator of `T`, and argument in the builder of one that takes
/// it.
pub struct Items<T>(PhantomData<T>);

impl<T> Clone for Items<T> {
    fn clone(&self) -> Self {
        Items(PhantomData)
    }
}

impl<T> Items<T> {
    /// Companion of an iterator's `clone`, with priority over that of values.
    pub fn __b_clone(&self) -> Called<containers::AsRef, Self> {
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

dsl_types! {
    [T] [T: Seen] Items<T> as Items<T::Slot> => |_| Ty::Unit;
}

never_held! { [T] Items<T>; }

/// Sequence behind a reference.
pub trait Held {
    /// Reference to its items.
    type Of;
}

macro_rules! held {
    ($([$($parameters:tt)*] $ty:ty: $of:ty;)*) => {$(
        impl<$($parameters)*> Held for $ty {
            type Of = $of;
        }
    )*};
}

held! {
    [T, const N: usize] [T; N]: T;
    [T] [T]: T;
    [T] Option<T>: T;
    [T, const N: usize] List<T, N>: T;
}

/// Implements the above for sequences: a reference argument is the sequence itself for an inlined function.
macro_rules! references {
    ($($reference:ident)*) => {$(
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

        impl<T: Held + ?Sized> IntoIterator for $reference<T> {
            type Item = $reference<T::Of>;
            type IntoIter = Items<$reference<T::Of>>;
            fn into_iter(self) -> Self::IntoIter {
                unreachable!("a witness copy is never run")
            }
        }
    )*};
}

references! { Shared Exclusive }

/// Type of an item in a slot.
pub(super) type Item<I> = <<I as Iterator>::Item as Seen>::Slot;

/// Result of a `try_fold`.
pub trait Tried<A> {}

impl<A> Tried<A> for Option<A> {}
impl<A, E> Tried<A> for Result<A, E> {}

/// A function that is applied to each item of type `T` until it fails.
pub trait TriesEach<T> {
    /// Marker of the consuming function.
    type Marker;
}

impl<T> TriesEach<T> for Option<()> {
    type Marker = iterate::__function_try_for_each_some<T>;
}

impl<T, E: Seen> TriesEach<T> for Result<(), E> {
    type Marker = iterate::__function_try_for_each_ok<T, E::Slot>;
}

/// Returns the items of an expression.
pub fn __items<I: IntoIterator>(_: I) -> Items<I::Item> {
    unreachable!("a witness copy is never run")
}

/// Passes the second iterator of a `zip` through, and records the function that takes its next item.
pub fn __beside<I: IntoIterator<Item: Seen>>(
    _: &Slot<iterate::__function_next<<I::Item as Seen>::Slot>>,
    items: I,
) -> I {
    items
}

companions! {
    pub mod traits[];
    /// Companion of `items.collect()` and `Inputs::from_iter(items)`: the author's function that collects items of
    /// type `A`.
    #[diagnostic::on_unimplemented(
        message = "`{Self}` cannot collect items of type `{A}`",
        label = "cannot collect these items",
        note = "mark an own `impl FromIterator<{A}>` block `#[data]`; fill a `List` with `extend`"
    )]
    pub trait FromIteratorBuiltin[A]: Sized {
        /// Marker of the function.
        type Marker;
        fn __b_from_iter[I: IntoIterator<Item = A>](_items: I) -> Self = [Self::Marker];
    }
    /// Companion of `gathered.extend(items)`: the author's function that adds items of type `A`.
    pub trait ExtendBuiltin[A] {
        /// Marker of the function.
        type Marker;
        fn __b_extend[I: IntoIterator<Item = A>](&mut self, _items: I) -> () = [Self::Marker];
    }
    /// Companions of consumers. Those that std takes by `&mut` take it so here, so that an author's own method of the
    /// name has priority.
    pub trait Ends: Iterator<Item: Seen>, Sized {
        fn __b_sum[S: core::iter::Sum<Self::Item>](self) -> S = Sum: Desugared(Desugared::Together(Together::Sum));
        fn __b_product[P: core::iter::Product<Self::Item>](self) -> P
            = Product: Desugared(Desugared::Together(Together::Product));
        fn __b_for_each[F: FnMut(Self::Item)](self, _: F) -> () = [iterate::__function_for_each<Item<Self>>];
        fn __b_try_for_each[R: TriesEach<Item<Self>>, F: FnMut(Self::Item) -> R](&mut self, _: F) -> R = [R::Marker];
        fn __b_reduce[F: FnMut(Self::Item, Self::Item) -> Self::Item](self, _: F) -> Option<Self::Item>
            = [iterate::__function_reduce<Item<Self>>];
        fn __b_nth(&mut self, _: usize) -> Option<Self::Item> = [iterate::__function_nth<Item<Self>>];
        fn __b_position[F: FnMut(Self::Item) -> bool](&mut self, _: F) -> Option<usize>
            = [iterate::__function_position<Item<Self>>];
        fn __b_rposition[F: FnMut(Self::Item) -> bool](&mut self, _: F) -> Option<usize>
            where Self: DoubleEndedIterator, Self: ExactSizeIterator
            = [iterate::__function_rposition<Item<Self>>];
        fn __b_max(self) -> Option<Self::Item> where Self::Item: Ord = [iterate::__function_max<Item<Self>>];
        fn __b_min(self) -> Option<Self::Item> where Self::Item: Ord = [iterate::__function_min<Item<Self>>];
        fn __b_count(self) -> usize = [iterate::__function_count<Item<Self>>];
        fn __b_fold[A: Seen, F: FnMut(A, Self::Item) -> A](self, _: A, _: F) -> A
            = [iterate::__function_fold<Item<Self>, A::Slot>];
        fn __b_try_fold[A, R: Tried<A>, F: FnMut(A, Self::Item) -> R](&mut self, _: A, _: F) -> R
            = TryFold: Desugared(Desugared::Together(Together::Tried));
        fn __b_any[F: FnMut(Self::Item) -> bool](&mut self, _: F) -> bool = [iterate::__function_any<Item<Self>>];
        fn __b_all[F: FnMut(Self::Item) -> bool](&mut self, _: F) -> bool = [iterate::__function_all<Item<Self>>];
        fn __b_find[F: FnMut(&Self::Item) -> bool](&mut self, _: F) -> Option<Self::Item>
            = [iterate::__function_find<Item<Self>>];
        fn __b_find_map[U: Seen, F: FnMut(Self::Item) -> Option<U>](&mut self, _: F) -> Option<U>
            = [iterate::__function_find_map<Item<Self>, U::Slot>];
        fn __b_max_by[F: FnMut(&Self::Item, &Self::Item) -> Ordering](self, _: F) -> Option<Self::Item>
            = [iterate::__function_max_by<Item<Self>>];
        fn __b_min_by[F: FnMut(&Self::Item, &Self::Item) -> Ordering](self, _: F) -> Option<Self::Item>
            = [iterate::__function_min_by<Item<Self>>];
        fn __b_max_by_key[K: Seen + Ord, F: FnMut(&Self::Item) -> K](self, _: F) -> Option<Self::Item>
            = [iterate::__function_max_by_key<Item<Self>, K::Slot>];
        fn __b_min_by_key[K: Seen + Ord, F: FnMut(&Self::Item) -> K](self, _: F) -> Option<Self::Item>
            = [iterate::__function_min_by_key<Item<Self>, K::Slot>];
        fn __b_cmp[I: IntoIterator<Item = Self::Item>](self, _: I) -> Ordering where Self::Item: Ord
            = [iterate::__function_cmp<Item<Self>>];
        fn __b_lt[U: Seen, I: IntoIterator<Item = U>](self, _: I) -> bool where Self::Item: PartialOrd<U>
            = [iterate::__function_lt<Item<Self>, U::Slot>];
        fn __b_le[U: Seen, I: IntoIterator<Item = U>](self, _: I) -> bool where Self::Item: PartialOrd<U>
            = [iterate::__function_le<Item<Self>, U::Slot>];
        fn __b_gt[U: Seen, I: IntoIterator<Item = U>](self, _: I) -> bool where Self::Item: PartialOrd<U>
            = [iterate::__function_gt<Item<Self>, U::Slot>];
        fn __b_ge[U: Seen, I: IntoIterator<Item = U>](self, _: I) -> bool where Self::Item: PartialOrd<U>
            = [iterate::__function_ge<Item<Self>, U::Slot>];
        fn __b_eq[U: Seen, I: IntoIterator<Item = U>](self, _: I) -> bool where Self::Item: PartialEq<U>
            = [iterate::__function_eq<Item<Self>, U::Slot>];
        fn __b_ne[U: Seen, I: IntoIterator<Item = U>](self, _: I) -> bool where Self::Item: PartialEq<U>
            = [iterate::__function_ne<Item<Self>, U::Slot>];
        fn __b_last(self) -> Option<Self::Item> = [iterate::__function_last<Item<Self>>];
        fn __b_next(&mut self) -> Option<Self::Item> = [iterate::__function_next<Item<Self>>];
        fn __b_next_back(&mut self) -> Option<Self::Item> where Self: DoubleEndedIterator
            = [iterate::__function_next_back<Item<Self>>];
        fn __b_len(&mut self) -> usize where Self: ExactSizeIterator = [iterate::__function_len<Item<Self>>];
    }
    /// Companions of adapters. Each returns [`Items`], so that a witness copy has one type of iterators, which no
    /// closure borrows.
    pub trait Adapters: Iterator<Item: Seen>, Sized {
        fn __b_map[U: Seen, F: FnMut(Self::Item) -> U](self, _: F) -> Items<U>
            = [adapt::__function_map<Item<Self>, U::Slot>];
        fn __b_filter[F: FnMut(&Self::Item) -> bool](self, _: F) -> Items<Self::Item>
            = [adapt::__function_filter<Item<Self>>];
        fn __b_filter_map[U: Seen, F: FnMut(Self::Item) -> Option<U>](self, _: F) -> Items<U>
            = [adapt::__function_filter_map<Item<Self>, U::Slot>];
        fn __b_map_while[U: Seen, F: FnMut(Self::Item) -> Option<U>](self, _: F) -> Items<U>
            = [adapt::__function_map_while<Item<Self>, U::Slot>];
        fn __b_take_while[F: FnMut(&Self::Item) -> bool](self, _: F) -> Items<Self::Item>
            = [adapt::__function_take_while<Item<Self>>];
        fn __b_skip_while[F: FnMut(&Self::Item) -> bool](self, _: F) -> Items<Self::Item>
            = [adapt::__function_skip_while<Item<Self>>];
        fn __b_skip(self, _: usize) -> Items<Self::Item> = [adapt::__function_skip<Item<Self>>];
        fn __b_take(self, _: usize) -> Items<Self::Item> = [adapt::__function_take<Item<Self>>];
        fn __b_zip[V: Seen, U: IntoIterator<Item = V>](self, _: U) -> Items<(Self::Item, V)>
            = [adapt::__function_zip<Item<Self>, V::Slot>];
        fn __b_step_by(self, _: usize) -> Items<Self::Item> = [adapt::__function_step_by<Item<Self>>];
        fn __b_scan[S: Seen, U: Seen, F: FnMut(&mut S, Self::Item) -> Option<U>](self, _: S, _: F) -> Items<U>
            = [adapt::__function_scan<Item<Self>, S::Slot, U::Slot>];
        fn __b_inspect[F: FnMut(&Self::Item)](self, _: F) -> Items<Self::Item>
            = [adapt::__function_inspect<Item<Self>>];
        fn __b_enumerate(self) -> Items<(usize, Self::Item)> = [adapt::__function_enumerate<Item<Self>>];
        fn __b_rev(self) -> Items<Self::Item> where Self: DoubleEndedIterator = [adapt::__function_rev<Item<Self>>];
        fn __b_flat_map[V: Seen, U: IntoIterator<Item = V>, F: FnMut(Self::Item) -> U](self, _: F) -> Items<V>
            = [adapt::__function_flat_map<Item<Self>, Items<V::Slot>, V::Slot>];
        fn __b_flatten[U: Seen](self) -> Items<U> where Self::Item: IntoIterator<Item = U>
            = [adapt::__function_flatten<Item<Self>, U::Slot>];
        fn __b_chain[U: IntoIterator<Item = Self::Item>](self, _: U) -> Items<Self::Item>
            = [adapt::__function_chain<Item<Self>>];
        fn __b_collect[C: FromIteratorBuiltin<Self::Item>](self) -> C = [C::Marker];
    }
    /// Companions of adapters that copy the values behind references.
    pub trait CopiedItems[T]: Sized {
        fn __b_copied(self) -> Items<T> where T: Seen = [adapt::__function_copied<T::Slot>];
        fn __b_cloned(self) -> Items<T> where T: Seen = [adapt::__function_copied<T::Slot>];
    }
    /// Companion that borrows an iterator with explicit `next` calls.
    pub trait ByHand: Iterator<Item: Seen>, Sized {
        fn __b_by_ref(&mut self) -> &mut Items<Self::Item> = ByRef: Desugared(Desugared::ByRef);
    }
}

impl<I: Iterator<Item: Seen>> Ends for I {}
impl<I: Iterator<Item: Seen>> Adapters for I {}
impl<'a, T: Seen + 'a, I: Iterator<Item = &'a T>> CopiedItems<T> for I {}
impl<I: Iterator<Item: Seen>> ByHand for I {}

/// Carriers of functions of `core::iter`.
#[allow(non_camel_case_types)]
pub mod iter {
    pub struct from_fn;
    pub struct successors;
}

calls! {
    iter::from_fn[T: Seen, F: FnMut() -> Option<T>](_f: F) -> Items<T> = [adapt::__function_from_fn<T::Slot>];
    iter::successors[T: Seen, F: FnMut(&T) -> Option<T>](_first: Option<T>, _f: F) -> Items<T>
        = [adapt::__function_successors<T::Slot>];
}
