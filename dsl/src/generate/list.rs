//! The companions of the methods of [`List`].

use bessemer_ir::tree::{self, ListMethod};

use super::builder::{Builder, Callee};
use super::builtin::{markers, signatures};
use super::matrices::told;
use super::slot::{Called, Value};
use crate::{List, list_edit};

markers! {
    New: List(ListMethod::New);
    Push: List(ListMethod::Push);
    Pop: List(ListMethod::Pop);
    Clear: List(ListMethod::Clear);
    Truncate: List(ListMethod::Truncate);
    Resize: List(ListMethod::Resize);
    Len: List(ListMethod::Len);
    IsEmpty: List(ListMethod::IsEmpty);
    Capacity: List(ListMethod::Capacity);
}

/// Methods of lists.
#[allow(missing_docs)]
pub trait ListBuiltins<T>: Sized {
    signatures! {
        fn __b_new() -> Called<New, Self>;
        fn __b_push(&mut self, _element: T) -> Called<Push, ()>;
        fn __b_pop(&mut self) -> Called<Pop, Option<T>>;
        fn __b_clear(&mut self) -> Called<Clear, ()>;
        fn __b_truncate(&mut self, _length: usize) -> Called<Truncate, ()>;
        fn __b_resize(&mut self, _length: usize, _element: T) -> Called<Resize, ()>;
        fn __b_len(&self) -> Called<Len, usize>;
        fn __b_is_empty(&self) -> Called<IsEmpty, bool>;
        fn __b_capacity(&self) -> Called<Capacity, usize>;
    }
}

impl<T, const N: usize> ListBuiltins<T> for List<T, N> {}

/// Methods of lists that are functions of the DSL in the C.
#[allow(missing_docs)]
pub trait ListEdits<T, const N: usize>: Sized {
    fn __b_is_full(&self) -> told!([Self, T, N] => bool);
    fn __b_insert(&mut self, index: usize, element: T) -> told!([Self, T, N] => ());
    fn __b_remove(&mut self, index: usize) -> told!([Self, T, N] => T);
    fn __b_swap_remove(&mut self, index: usize) -> told!([Self, T, N] => T);
    fn __b_extend_from_slice(&mut self, elements: &[T]) -> told!([Self, T, N] => ());
    fn __b_retain<F: FnMut(&T) -> bool>(&mut self, keep: F) -> told!([Self, T, N] + F => ());
}

impl<T: Value + Copy + Default, const N: usize> ListEdits<T, N> for List<T, N> {
    fn __b_is_full(&self) -> told!([T, N] => bool) {
        list_edit::is_full::__call(self)
    }
    fn __b_insert(&mut self, index: usize, element: T) -> told!([T, N] => ()) {
        list_edit::insert::__call(self, index, element)
    }
    fn __b_remove(&mut self, index: usize) -> told!([T, N] => T) {
        list_edit::remove::__call(self, index)
    }
    fn __b_swap_remove(&mut self, index: usize) -> told!([T, N] => T) {
        list_edit::swap_remove::__call(self, index)
    }
    fn __b_extend_from_slice(&mut self, elements: &[T]) -> told!([T, N] => ()) {
        list_edit::extend_from_slice::__call(self, elements)
    }
    fn __b_retain<F: FnMut(&T) -> bool>(&mut self, keep: F) -> told!([T, N] + F => ()) {
        list_edit::retain::__call(self, keep)
    }
}

/// `list.extend(items)`, of items of type `E`: elements, or references to them.
#[allow(missing_docs)]
pub trait ListExtends<E, T, const N: usize>: Sized {
    fn __b_extend<I: IntoIterator<Item = E>>(
        &mut self,
        items: I,
    ) -> told!([Self, E, T, N] + I => ());
}

impl<T: Value + Copy + Default, const N: usize> ListExtends<T, T, N> for List<T, N> {
    fn __b_extend<I: IntoIterator<Item = T>>(&mut self, items: I) -> told!([T, N] + I => ()) {
        list_edit::extend::__call(self, items)
    }
}

impl<'a, T: Value + Copy + Default, const N: usize> ListExtends<&'a T, T, N> for List<T, N> {
    fn __b_extend<I: IntoIterator<Item = &'a T>>(
        &mut self,
        items: I,
    ) -> Called<impl Callee + use<'a, T, N, I>, ()> {
        list_edit::extend_by::__call(self, items)
    }
}
