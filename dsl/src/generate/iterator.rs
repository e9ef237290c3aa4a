//! Iterators that authors' functions give or take: nothing in the C, where what goes through them stands in the loop that
//! gives them.

#![allow(missing_docs)]

use core::marker::PhantomData;

use bessemer_ir::tree::{self, Desugared, Gather, Ty};

use super::builder::{Builder, Callee};
use super::builtin::markers;
use super::slot::{Called, DslType, Seen};

markers! {
    Next: Desugared(Desugared::Gather(Gather::Next));
    Last: Desugared(Desugared::Gather(Gather::Last));
    Count: Desugared(Desugared::Gather(Gather::Count));
    Sum: Desugared(Desugared::Gather(Gather::Sum));
    Product: Desugared(Desugared::Gather(Gather::Product));
}

/// What the companion of a function gives that gives an iterator of `T`, and what the builder of one that takes it has.
pub struct Items<T>(PhantomData<T>);

impl<T> Clone for Items<T> {
    fn clone(&self) -> Self {
        Items(PhantomData)
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

impl<T> Seen for Items<T> {
    type Slot = Items<()>;
}

impl<T> Items<T> {
    pub fn __b_next(&mut self) -> Called<Next, Option<T>> {
        unreachable!()
    }
    pub fn __b_last(self) -> Called<Last, Option<T>> {
        unreachable!()
    }
    pub fn __b_sum<S: core::iter::Sum<T>>(self) -> Called<Sum, S> {
        unreachable!()
    }
    pub fn __b_product<P: core::iter::Product<T>>(self) -> Called<Product, P> {
        unreachable!()
    }
    pub fn __b_count(self) -> Called<Count, usize> {
        unreachable!()
    }
}
