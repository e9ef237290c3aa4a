//! The companions of the methods of [`List`].

use bessemer_ir::tree::{self, ListMethod};

use super::builder::{Builder, Callee};
use super::builtin::{markers, operations};
use super::matrices::{told, told_methods};
use super::slot::{Called, Value};
use crate::{List, list_edit};

operations! {
    /// Methods of lists.
    pub trait ListBuiltins<T>: Sized {
        fn __b_new() -> Self = New: List(ListMethod::New);
        fn __b_push(&mut self, _element: T) -> () = Push: List(ListMethod::Push);
        fn __b_pop(&mut self) -> Option<T> = Pop: List(ListMethod::Pop);
        fn __b_clear(&mut self) -> () = Clear: List(ListMethod::Clear);
        fn __b_truncate(&mut self, _length: usize) -> () = Truncate: List(ListMethod::Truncate);
        fn __b_resize(&mut self, _length: usize, _element: T) -> () = Resize: List(ListMethod::Resize);
        fn __b_len(&self) -> usize = Len: List(ListMethod::Len);
        fn __b_is_empty(&self) -> bool = IsEmpty: List(ListMethod::IsEmpty);
        fn __b_capacity(&self) -> usize = Capacity: List(ListMethod::Capacity);
    }
}

impl<T, const N: usize> ListBuiltins<T> for List<T, N> {}

told_methods! {
    /// Methods of lists that are functions of the DSL in the C.
    ListEdits<T; N> [Self, T, N]: Sized for (T: (Value + Copy + Default)) List<T, N>, [T, N] {
        fn __b_is_full(&self) -> bool { list_edit::is_full::__call(self) }
        fn __b_insert(&mut self, index: usize, element: T) -> () {
            list_edit::insert::__call(self, index, element)
        }
        fn __b_remove(&mut self, index: usize) -> T { list_edit::remove::__call(self, index) }
        fn __b_swap_remove(&mut self, index: usize) -> T { list_edit::swap_remove::__call(self, index) }
        fn __b_extend_from_slice(&mut self, elements: &[T]) -> () {
            list_edit::extend_from_slice::__call(self, elements)
        }
        fn __b_retain[F: (FnMut(&T) -> bool)](&mut self, keep: F) -> () {
            list_edit::retain::__call(self, keep)
        }
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
