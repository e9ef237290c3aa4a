//! The companions of the methods of [`List`].

#![allow(missing_docs)]

use bessemer_ir::tree::{self, ListMethod};

use super::builder::{Builder, Callee};
use super::builtin::companions;
use super::slot::{Called, Value};
use crate::{List, list_edit};

companions! {
    /// Methods of lists.
    impl[T, const N: usize] ListBuiltins<T, N> for List<T, N> {
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
    /// `list.extend(items)`, of items of type `E`: elements, or references to them.
    pub trait ListExtends[E]: Sized {
        /// Which function it is.
        type Marker;
        fn __b_extend[I: IntoIterator<Item = E>](&mut self, _items: I) -> () = [Self::Marker];
    }
}

impl<T: Value + Copy + Default, const N: usize> ListExtends<T> for List<T, N> {
    type Marker = list_edit::__function_extend<T, N>;
}

impl<T: Value + Copy + Default, const N: usize> ListExtends<&T> for List<T, N> {
    type Marker = list_edit::__function_extend_by<T, N>;
}
