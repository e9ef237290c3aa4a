//! Tables of an author: arrays of numbers over the points of other fields, by `#[axes(…)]`.
//!
//! Must not know: how a table is looked up.

use alloc::vec::Vec;

use crate::ir::{Module, Type};
use crate::{Form, Scalar};

/// Points of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Points {
    /// Number of points.
    pub count: u32,
    /// True if they are the one field of a struct, rather than an array.
    pub within: bool,
}

/// Returns the lengths of an array of numbers, from the outside in; none for another type.
pub fn lengths(ty: &Type) -> Option<Vec<u32>> {
    let mut lengths = Vec::new();
    let mut inner: &Type = ty;
    while let Type::Array { element, len } = inner {
        lengths.push(*len);
        inner = element;
    }
    let is_number = matches!(inner, Type::Scalar(scalar) if *scalar != Scalar::Bool);
    (is_number && !lengths.is_empty()).then_some(lengths)
}

/// Returns the points of a field that is an axis: an array of numbers, or a struct with one as its only field.
pub fn points(module: &Module, ty: &Type) -> Option<Points> {
    let one = |ty: &Type| match *lengths(ty)? {
        [count] => Some(count),
        _ => None,
    };
    match ty {
        Type::Struct(id) => {
            let item = &module.structs[id.index()];
            let [field] = &*item.fields else { return None };
            let count = one(&field.ty).filter(|_| item.form == Form::Record)?;
            Some(Points { count, within: true })
        }
        ty => Some(Points { count: one(ty)?, within: false }),
    }
}
