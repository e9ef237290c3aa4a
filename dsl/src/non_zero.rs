//! Integers that are not zero: the C of core's `NonZeroU32` and the like, a struct of one number.
//!
//! A caller of the C must not pass a zero in one, just as it must not pass an enum that is none of its variants. No
//! proof relies on that: `get` may return any number there, and a division by it has a check.

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
        /// The word 0, which is not a value of the type, is read as 1.
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
