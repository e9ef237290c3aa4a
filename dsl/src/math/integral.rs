//! `Integer`: the operations of a model that is generic over its integer type.

use core::ops::{BitAnd, BitOr, BitXor, Div, Rem, Shl, Shr};

use crate::element::Number;

/// A signed or an unsigned integer.
///
/// A function, a type or a component that is generic over `T: Integer` becomes C for each integer that it is used with.
///
/// ```
/// use bessemer::prelude::*;
///
/// /// The bits of `word` that differ from those of `other`.
/// #[function]
/// fn distance<T: Integer>(word: T, other: T) -> u32 {
///     (word ^ other).count_ones()
/// }
///
/// assert_eq!(distance(0x0F_u8, 0x0A), 2);
/// assert_eq!(distance(-1_i32, 0), 32);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an integer of the DSL",
    label = "not `i8` to `i64`, `u8` to `u64`, `isize` or `usize`"
)]
pub trait Integer:
    Number
    + Eq
    + Div<Output = Self>
    + Rem<Output = Self>
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + BitXor<Output = Self>
    + Shl<u32, Output = Self>
    + Shr<u32, Output = Self>
    + generated::Generated
{
    /// 1.
    const ONE: Self;
    /// The largest value.
    const MAX: Self;
    /// The smallest value.
    const MIN: Self;
    /// Number of bits.
    const BITS: u32;
    /// The mask of the lower four bits of each byte.
    #[doc(hidden)]
    const NIBBLES: Self;
    /// The mask of the lower two of each four bits.
    #[doc(hidden)]
    const PAIRS: Self;
    /// The mask of the lower of each two bits.
    #[doc(hidden)]
    const ODDS: Self;

    /// `self + other`, wrapped to the type's width.
    #[must_use]
    fn wrapping_add(self, other: Self) -> Self;
    /// `self - other`, wrapped to the type's width.
    #[must_use]
    fn wrapping_sub(self, other: Self) -> Self;
    /// `self * other`, wrapped to the type's width.
    #[must_use]
    fn wrapping_mul(self, other: Self) -> Self;
    /// `self / other`, wrapped to the type's width.
    ///
    /// # Panics
    /// For a divisor of 0.
    #[must_use]
    fn wrapping_div(self, other: Self) -> Self;
    /// Shifts left by `bits` modulo the width.
    #[must_use]
    fn wrapping_shl(self, bits: u32) -> Self;
    /// Shifts right by `bits` modulo the width; a signed number keeps its sign.
    #[must_use]
    fn wrapping_shr(self, bits: u32) -> Self;
    /// The number with its bytes in reverse order.
    #[must_use]
    fn swap_bytes(self) -> Self;
    /// Number of bits that are 1.
    fn count_ones(self) -> u32;
    /// Number of zero bits above the highest 1.
    fn leading_zeros(self) -> u32;
    /// Number of zero bits below the lowest 1.
    fn trailing_zeros(self) -> u32;
}

macro_rules! integers {
    ($($int:ident $unsigned:ident)*) => {$(
        impl Integer for $int {
            const ONE: $int = 1;
            const MAX: $int = $int::MAX;
            const MIN: $int = $int::MIN;
            const BITS: u32 = $int::BITS;
            const NIBBLES: $int = ($unsigned::MAX / 17) as $int;
            const PAIRS: $int = ($unsigned::MAX / 5) as $int;
            const ODDS: $int = ($unsigned::MAX / 3) as $int;

            fn wrapping_add(self, other: $int) -> $int {
                self.wrapping_add(other)
            }
            fn wrapping_sub(self, other: $int) -> $int {
                self.wrapping_sub(other)
            }
            fn wrapping_mul(self, other: $int) -> $int {
                self.wrapping_mul(other)
            }
            fn wrapping_div(self, other: $int) -> $int {
                self.wrapping_div(other)
            }
            fn wrapping_shl(self, bits: u32) -> $int {
                self.wrapping_shl(bits)
            }
            fn wrapping_shr(self, bits: u32) -> $int {
                self.wrapping_shr(bits)
            }
            fn swap_bytes(self) -> $int {
                self.swap_bytes()
            }
            fn count_ones(self) -> u32 {
                self.count_ones()
            }
            fn leading_zeros(self) -> u32 {
                self.leading_zeros()
            }
            fn trailing_zeros(self) -> u32 {
                self.trailing_zeros()
            }
        }
    )*};
}

integers! {
    i8 u8 i16 u16 i32 u32 i64 u64 isize usize u8 u8 u16 u16 u32 u32 u64 u64 usize usize
}

/// Additional supertraits of `Integer` in a generation build.
#[cfg(feature = "generate")]
mod generated {
    use crate::generate::numbers::{DivisionBuiltins, IntegerBuiltins, OrderBuiltins};
    use crate::generate::{ScalarType, Value};

    pub trait Generated:
        Value + ScalarType + OrderBuiltins + IntegerBuiltins + DivisionBuiltins
    {
    }

    impl<T> Generated for T where
        T: Value + ScalarType + OrderBuiltins + IntegerBuiltins + DivisionBuiltins
    {
    }
}

/// Additional supertraits of `Integer` in a generation build: none if this is not one.
#[cfg(not(feature = "generate"))]
mod generated {
    pub trait Generated {}

    impl<T> Generated for T {}
}
