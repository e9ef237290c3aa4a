//! The companions of what iterators are made of others with.
//!
//! Each gives [`Items`], so that a witness copy has one type of iterators, which no closure borrows.

#![allow(missing_docs)]

use bessemer_ir::tree;

use super::builder::{Builder, Callee};
use super::iterator::{FromIteratorBuiltin, Item, Items, takes_items};
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

/// A companion of an adapter, by its marker and the items that it gives.
macro_rules! adapters {
    ($(
        $name:ident $([$($g:ident: $bound:path),+])? ($($parameter:ty),*)
            -> $marker:ty, $item:ty $(where $of:ty: $such:path)?;
    )*) => {
        /// What iterators are made of others with.
        pub trait Adapters: Iterator<Item: Seen> + Sized {$(
            fn $name $(<$($g: $bound),+>)? (self, $(_: $parameter),*) -> Called<$marker, Items<$item>>
            $(where $of: $such)?
            {
                unreachable!("a witness copy is never run")
            }
        )*
            fn __b_collect<C: FromIteratorBuiltin<Self::Item>>(self) -> Called<C::Marker, C> {
                unreachable!("a witness copy is never run")
            }
            fn __b_copied<'a, T: Seen + 'a>(self) -> Called<Copied<T::Slot>, Items<T>>
            where
                Self: Iterator<Item = &'a T>,
            {
                unreachable!("a witness copy is never run")
            }
            fn __b_cloned<'a, T: Seen + 'a>(self) -> Called<Copied<T::Slot>, Items<T>>
            where
                Self: Iterator<Item = &'a T>,
            {
                unreachable!("a witness copy is never run")
            }
        }
    };
}

adapters! {
    __b_map[U: Seen, F: FnMut(Self::Item) -> U](F) -> Map<Item<Self>, U::Slot>, U;
    __b_filter[F: FnMut(&Self::Item) -> bool](F) -> Filter<Item<Self>>, Self::Item;
    __b_filter_map[U: Seen, F: FnMut(Self::Item) -> Option<U>](F)
        -> FilterMap<Item<Self>, U::Slot>, U;
    __b_map_while[U: Seen, F: FnMut(Self::Item) -> Option<U>](F)
        -> MapWhile<Item<Self>, U::Slot>, U;
    __b_take_while[F: FnMut(&Self::Item) -> bool](F) -> TakeWhile<Item<Self>>, Self::Item;
    __b_skip_while[F: FnMut(&Self::Item) -> bool](F) -> SkipWhile<Item<Self>>, Self::Item;
    __b_skip(usize) -> Skip<Item<Self>>, Self::Item;
    __b_step_by(usize) -> StepBy<Item<Self>>, Self::Item;
    __b_scan[S: Seen, U: Seen, F: FnMut(&mut S, Self::Item) -> Option<U>](S, F)
        -> Scan<Item<Self>, S::Slot, U::Slot>, U;
    __b_inspect[F: FnMut(&Self::Item)](F) -> Inspect<Item<Self>>, Self::Item;
    __b_enumerate() -> Enumerate<Item<Self>>, (usize, Self::Item);
    __b_rev() -> Rev<Item<Self>>, Self::Item where Self: DoubleEndedIterator;
    __b_flat_map[V: Seen, U: IntoIterator<Item = V>, F: FnMut(Self::Item) -> U](F)
        -> FlatMap<Item<Self>, V::Slot>, V;
    __b_flatten[U: Seen]() -> Flatten<Item<Self>, U::Slot>, U where Self::Item: IntoIterator<Item = U>;
    __b_chain[U: IntoIterator<Item = Self::Item>](U) -> Chain<Item<Self>>, Self::Item;
}

impl<I: Iterator<Item: Seen>> Adapters for I {}
