//! The companions of what iterators are made of others with.
//!
//! Each gives [`Items`], so that a witness copy has one type of iterators, which no closure borrows.

#![allow(missing_docs)]

use bessemer_ir::tree;

use super::builder::{Builder, Callee};
use super::builtin::signatures;
use super::iterator::{FromIteratorBuiltin, Item, Items, of_iterators, takes_items};
use super::slot::{Called, Companion, Exclusive, Seen, Shared, Value};
use crate::{List, adapt};
use core::marker::PhantomData;

/// What an expression is gone through for.
pub fn __items<I: IntoIterator>(_: I) -> Items<I::Item> {
    unreachable!("a witness copy is never run")
}

/// What a reference to it is gone through for.
pub trait Held {
    /// References to these.
    type Of;
}

impl<T, const N: usize> Held for [T; N] {
    type Of = T;
}

impl<T> Held for [T] {
    type Of = T;
}

impl<T> Held for Option<T> {
    type Of = T;
}

impl<T, const N: usize> Held for List<T, N> {
    type Of = T;
}

macro_rules! references {
    ($($reference:ident)*) => {$(
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

takes_items! { adapt:
    Map<T, U>: map(Items<T>, fn(T) -> U, fn(U));
    Filter<T>: filter(Items<T>, fn(&T) -> bool, fn(T));
    FilterMap<T, U>: filter_map(Items<T>, fn(T) -> Option<U>, fn(U));
    MapWhile<T, U>: map_while(Items<T>, fn(T) -> Option<U>, fn(U));
    TakeWhile<T>: take_while(Items<T>, fn(&T) -> bool, fn(T));
    SkipWhile<T>: skip_while(Items<T>, fn(&T) -> bool, fn(T));
    Skip<T>: skip(Items<T>, usize, fn(T));
    Take<T>: take(Items<T>, usize, fn(T));
    Zip<T, U>: zip(Items<T>, Items<U>, fn((T, U)));
    StepBy<T>: step_by(Items<T>, usize, fn(T));
    Scan<T, S, U>: scan(Items<T>, S, fn(&mut S, T) -> Option<U>, fn(U));
    Inspect<T>: inspect(Items<T>, fn(&T), fn(T));
    Copied<T: Copy>: copied(Items<&'static T>, fn(T));
    Enumerate<T>: enumerate(Items<T>, fn((usize, T)));
    Rev<T>: rev(Items<T>, fn(T));
    FlatMap<T, U>: flat_map(Items<T>, fn(T) -> Items<U>, fn(U));
    Flatten<T: adapt::Of<U>, U>: flatten(Items<T>, fn(U));
    Chain<T>: chain(Items<T>, Items<T>, fn(T));
}

of_iterators! {
    /// What iterators are made of others with.
    Adapters {
        __b_map[U: Seen, F: FnMut(Self::Item) -> U](F) -> Map<Item<Self>, U::Slot>, Items<U>;
        __b_filter[F: FnMut(&Self::Item) -> bool](F) -> Filter<Item<Self>>, Items<Self::Item>;
        __b_filter_map[U: Seen, F: FnMut(Self::Item) -> Option<U>](F)
            -> FilterMap<Item<Self>, U::Slot>, Items<U>;
        __b_map_while[U: Seen, F: FnMut(Self::Item) -> Option<U>](F)
            -> MapWhile<Item<Self>, U::Slot>, Items<U>;
        __b_take_while[F: FnMut(&Self::Item) -> bool](F)
            -> TakeWhile<Item<Self>>, Items<Self::Item>;
        __b_skip_while[F: FnMut(&Self::Item) -> bool](F)
            -> SkipWhile<Item<Self>>, Items<Self::Item>;
        __b_skip(usize) -> Skip<Item<Self>>, Items<Self::Item>;
        __b_take(usize) -> Take<Item<Self>>, Items<Self::Item>;
        __b_zip[V: Seen, U: IntoIterator<Item = V>](U)
            -> Zip<Item<Self>, V::Slot>, Items<(Self::Item, V)>;
        __b_step_by(usize) -> StepBy<Item<Self>>, Items<Self::Item>;
        __b_scan[S: Seen, U: Seen, F: FnMut(&mut S, Self::Item) -> Option<U>](S, F)
            -> Scan<Item<Self>, S::Slot, U::Slot>, Items<U>;
        __b_inspect[F: FnMut(&Self::Item)](F) -> Inspect<Item<Self>>, Items<Self::Item>;
        __b_enumerate() -> Enumerate<Item<Self>>, Items<(usize, Self::Item)>;
        __b_rev() -> Rev<Item<Self>>, Items<Self::Item> where Self: DoubleEndedIterator;
        __b_flat_map[V: Seen, U: IntoIterator<Item = V>, F: FnMut(Self::Item) -> U](F)
            -> FlatMap<Item<Self>, V::Slot>, Items<V>;
        __b_flatten[U: Seen]() -> Flatten<Item<Self>, U::Slot>, Items<U>
            where Self::Item: IntoIterator<Item = U>;
        __b_chain[U: IntoIterator<Item = Self::Item>](U) -> Chain<Item<Self>>, Items<Self::Item>;
        __b_collect[C: FromIteratorBuiltin<Self::Item>]() -> C::Marker, C;
    }
}

/// What gives the values behind references.
pub trait CopiedItems<'a, T: Seen + 'a>: Iterator<Item = &'a T> + Sized {
    signatures! {
        fn __b_copied(self) -> Called<Copied<T::Slot>, Items<T>>;
        fn __b_cloned(self) -> Called<Copied<T::Slot>, Items<T>>;
    }
}

impl<'a, T: Seen + 'a, I: Iterator<Item = &'a T>> CopiedItems<'a, T> for I {}
