//! Uses of an own `Deref`: by a method, an operator, a field and an argument.
#![no_std]
use bessemer::prelude::*;

/// Inner part.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inner {
    /// A number.
    pub x: f64,
}

#[data]
impl Inner {
    /// Half of it.
    pub fn half(&self) -> f64 {
        0.5 * self.x
    }
}

/// Outer part.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outer {
    /// Inner part.
    pub inner: Inner,
}

impl core::ops::Deref for Outer {
    type Target = Inner;
    fn deref(&self) -> &Inner {
        &self.inner
    }
}

/// By a field.
#[function]
pub fn field(outer: Outer) -> f64 {
    outer.x
}

/// By the operator.
#[function]
pub fn whole(outer: Outer) -> f64 {
    let inner = *outer;
    inner.x
}
