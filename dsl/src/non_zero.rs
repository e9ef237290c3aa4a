//! Integers that are not zero: what core's `NonZeroU32` and its like are in the C, a struct of one number.
//!
//! A caller of the C passes no zero in one, as it passes no enum that is none of its variants. No proof rests on it: what
//! `get` gives may be any number there, and a division by it has its check.

use core::num::NonZero as Native;

use crate::Plain;
use crate::prelude::*;

/// An integer that is not zero.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NonZero<T> {
    /// The integer.
    pub value: T,
}

/// The integer, unless it is zero.
#[function]
pub fn new<T: Integer>(value: T) -> Option<NonZero<T>> {
    if value == T::ZERO { None } else { Some(NonZero { value }) }
}

/// The integer.
#[function(expand)]
pub fn get<T: Integer>(it: NonZero<T>) -> T {
    it.value
}

macro_rules! integers {
    ($($int:ident)*) => {$(
        /// The word of a zero, which is none of them, becomes a one.
        #[diagnostic::do_not_recommend]
        impl Plain for Native<$int> {
            const WORDS: usize = 1;
            fn store(&self, out: &mut dyn FnMut(u64)) {
                self.get().store(out);
            }
            fn load(next: &mut dyn FnMut() -> u64) -> Self {
                let value = <$int>::load(next);
                Native::new(value).or(Native::new(1)).unwrap_or(Native::<$int>::MAX)
            }
        }
    )*};
}

integers! { i8 i16 i32 i64 isize u8 u16 u32 u64 usize }
