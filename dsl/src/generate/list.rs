//! The companions of the methods of [`List`].

use alloc::borrow::ToOwned;

use bessemer_ir::tree;

use super::builtin::markers;
use super::{Builder, Called, Callee};
use crate::List;

markers! {
    New: "list_new";
    Push: "list_push";
    Pop: "list_pop";
    Clear: "list_clear";
    Truncate: "list_truncate";
    Resize: "list_resize";
    Len: "list_len";
    IsEmpty: "list_is_empty";
    Capacity: "list_capacity";
}

/// Methods of lists.
#[allow(missing_docs)]
pub trait ListBuiltins<T>: Sized {
    fn __b_new() -> Called<New, Self> {
        unreachable!()
    }
    fn __b_push(&mut self, _element: T) -> Called<Push, ()> {
        unreachable!()
    }
    fn __b_pop(&mut self) -> Called<Pop, Option<T>> {
        unreachable!()
    }
    fn __b_clear(&mut self) -> Called<Clear, ()> {
        unreachable!()
    }
    fn __b_truncate(&mut self, _length: usize) -> Called<Truncate, ()> {
        unreachable!()
    }
    fn __b_resize(&mut self, _length: usize, _element: T) -> Called<Resize, ()> {
        unreachable!()
    }
    fn __b_len(&self) -> Called<Len, usize> {
        unreachable!()
    }
    fn __b_is_empty(&self) -> Called<IsEmpty, bool> {
        unreachable!()
    }
    fn __b_capacity(&self) -> Called<Capacity, usize> {
        unreachable!()
    }
}

impl<T, const N: usize> ListBuiltins<T> for List<T, N> {}
