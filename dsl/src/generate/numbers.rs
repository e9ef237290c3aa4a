//! Companions of methods of numbers, and of letter and digit tests of bytes and characters.

#![allow(missing_docs)]

use core::num::TryFromIntError;

use bessemer_tree as tree;
use bessemer_tree::operation::Intrinsic;
use bessemer_tree::{ByteOrder, NumberMethod, Ty};

use super::builder::{Builder, Callee};
use super::companions::{companions, markers};
use super::slot::{Called, DslType, Seen, Value, dsl_types};
use crate::math::whole::WholeCompanions;
use crate::math::{ascii, checked, integer, roots};

markers! {
    From: Number(NumberMethod::From);
    TryFrom: TryFrom;
    Real: Real;
    Same: Owned;
    Little: Bytes(ByteOrder::Little);
    Big: Bytes(ByteOrder::Big);
    Signum: Number(NumberMethod::Signum);
    DivEuclid: Number(NumberMethod::DivEuclid);
    RemEuclid: Number(NumberMethod::RemEuclid);
    Abs: Scalar(Intrinsic::Abs);
    Min: Scalar(Intrinsic::Min);
    Max: Scalar(Intrinsic::Max);
    Clamp: Scalar(Intrinsic::Clamp);
}

companions! {
    pub mod traits[];
    /// Methods of integers.
    pub trait IntegerBuiltins: Sized {
        type Unsigned;
        fn __b_wrapping_add(self, _other: Self) -> Self = WrappingAdd: Scalar(Intrinsic::WrappingAdd);
        fn __b_wrapping_sub(self, _other: Self) -> Self = WrappingSub: Scalar(Intrinsic::WrappingSub);
        fn __b_wrapping_mul(self, _other: Self) -> Self = WrappingMul: Scalar(Intrinsic::WrappingMul);
        fn __b_wrapping_div(self, _other: Self) -> Self = WrappingDiv: Number(NumberMethod::WrappingDiv);
        fn __b_wrapping_rem(self, _other: Self) -> Self = WrappingRem: Number(NumberMethod::WrappingRem);
        fn __b_saturating_add(self, _other: Self) -> Self = SaturatingAdd: Scalar(Intrinsic::SaturatingAdd);
        fn __b_saturating_sub(self, _other: Self) -> Self = SaturatingSub: Scalar(Intrinsic::SaturatingSub);
        fn __b_saturating_mul(self, _other: Self) -> Self = SaturatingMul: Scalar(Intrinsic::SaturatingMul);
        fn __b_wrapping_neg(self) -> Self = WrappingNeg: Number(NumberMethod::WrappingNeg);
        fn __b_swap_bytes(self) -> Self = SwapBytes: Number(NumberMethod::SwapBytes);
        fn __b_wrapping_shl(self, _bits: u32) -> Self = WrappingShl: Number(NumberMethod::WrappingShl);
        fn __b_wrapping_shr(self, _bits: u32) -> Self = WrappingShr: Number(NumberMethod::WrappingShr);
        fn __b_rotate_left(self, _bits: u32) -> Self = RotateLeft: Number(NumberMethod::RotateLeft);
        fn __b_rotate_right(self, _bits: u32) -> Self = RotateRight: Number(NumberMethod::RotateRight);
        fn __b_count_ones(self) -> u32 = CountOnes: Number(NumberMethod::CountOnes);
        fn __b_count_zeros(self) -> u32 = CountZeros: Number(NumberMethod::CountZeros);
        fn __b_leading_zeros(self) -> u32 = LeadingZeros: Number(NumberMethod::LeadingZeros);
        fn __b_leading_ones(self) -> u32 = LeadingOnes: Number(NumberMethod::LeadingOnes);
        fn __b_trailing_zeros(self) -> u32 = TrailingZeros: Number(NumberMethod::TrailingZeros);
        fn __b_trailing_ones(self) -> u32 = TrailingOnes: Number(NumberMethod::TrailingOnes);
        fn __b_to_le(self) -> Self = [From];
        fn __b_to_be(self) -> Self = SwapBytes;
        fn __b_from_le(_word: Self) -> Self = [From];
        fn __b_from_be(_word: Self) -> Self = SwapBytes;
        fn __b_abs_diff(self, _other: Self) -> Self::Unsigned = AbsDiff: Number(NumberMethod::AbsDiff);
        fn __b_pow(self, _exponent: u32) -> Self = <Pow>;
        fn __b_wrapping_pow(self, _exponent: u32) -> Self = <WrappingPow>;
        fn __b_checked_add(self, _other: Self) -> Option<Self> = <CheckedAdd>;
        fn __b_checked_sub(self, _other: Self) -> Option<Self> = <CheckedSub>;
        fn __b_checked_mul(self, _other: Self) -> Option<Self> = <CheckedMul>;
        fn __b_checked_div(self, _other: Self) -> Option<Self> = <CheckedDiv>;
        fn __b_checked_rem(self, _other: Self) -> Option<Self> = <CheckedRem>;
        fn __b_checked_neg(self) -> Option<Self> = <CheckedNeg>;
        fn __b_checked_shl(self, _bits: u32) -> Option<Self> = <CheckedShl>;
        fn __b_checked_shr(self, _bits: u32) -> Option<Self> = <CheckedShr>;
        fn __b_checked_pow(self, _exponent: u32) -> Option<Self> = <CheckedPow>;
    }
    /// Methods of signed integers.
    pub trait SignedBuiltins: IntegerBuiltins {
        fn __b_checked_abs(self) -> Option<Self> = <CheckedAbs>;
        fn __b_saturating_neg(self) -> Self = <SaturatingNeg>;
        fn __b_saturating_abs(self) -> Self = <SaturatingAbs>;
        fn __b_is_positive(self) -> bool = IsPositive: Number(NumberMethod::IsPositive);
        fn __b_is_negative(self) -> bool = IsNegative: Number(NumberMethod::IsNegative);
        fn __b_wrapping_abs(self) -> Self = WrappingAbs: Number(NumberMethod::WrappingAbs);
        fn __b_unsigned_abs(self) -> Self::Unsigned = UnsignedAbs: Scalar(Intrinsic::UnsignedAbs);
    }
    /// Methods of unsigned integers, and sums with signed ones.
    pub trait UnsignedBuiltins: Sized {
        type Signed;
        fn __b_checked_add_signed(self, _other: Self::Signed) -> Option<Self> = <CheckedAddSigned>;
        fn __b_saturating_add_signed(self, _other: Self::Signed) -> Self = <SaturatingAddSigned>;
        fn __b_wrapping_add_signed(self, _other: Self::Signed) -> Self = <WrappingAddSigned>;
        fn __b_is_power_of_two(self) -> bool = IsPowerOfTwo: Number(NumberMethod::IsPowerOfTwo);
    }
    /// Methods that return the sign as a number.
    pub trait SignBuiltins: Sized {
        fn __b_signum(self) -> Self = <Signum>;
    }
    /// Division whose remainder is not negative.
    pub trait DivisionBuiltins: Sized {
        fn __b_div_euclid(self, _other: Self) -> Self = <DivEuclid>;
        fn __b_rem_euclid(self, _other: Self) -> Self = <RemEuclid>;
    }
    /// Methods of floats: exact ones, conversions from and to bits, and double precision.
    pub trait FloatBuiltins: Sized {
        type Bits: Value;
        fn __b_sqrt(self) -> Self = Sqrt: Scalar(Intrinsic::Sqrt);
        fn __b_floor(self) -> Self = Floor: Scalar(Intrinsic::Floor);
        fn __b_ceil(self) -> Self = Ceil: Scalar(Intrinsic::Ceil);
        fn __b_trunc(self) -> Self = Trunc: Scalar(Intrinsic::Trunc);
        fn __b_round(self) -> Self = Round: Scalar(Intrinsic::Round);
        fn __b_fract(self) -> Self = Fract: Number(NumberMethod::Fract);
        fn __b_try_sqrt(self) -> Option<Self> = [roots::__function_try_sqrt<Self>];
        fn __b_recip(self) -> Self = Recip: Number(NumberMethod::Recip);
        fn __b_to_degrees(self) -> Self = ToDegrees: Number(NumberMethod::ToDegrees);
        fn __b_to_radians(self) -> Self = ToRadians: Number(NumberMethod::ToRadians);
        fn __b_is_nan(self) -> bool = IsNan: Scalar(Intrinsic::IsNan);
        fn __b_is_finite(self) -> bool = IsFinite: Scalar(Intrinsic::IsFinite);
        fn __b_is_infinite(self) -> bool = IsInfinite: Scalar(Intrinsic::IsInfinite);
        fn __b_is_sign_negative(self) -> bool = IsSignNegative: Number(NumberMethod::IsSignNegative);
        fn __b_is_sign_positive(self) -> bool = IsSignPositive: Number(NumberMethod::IsSignPositive);
        fn __b_copysign(self, _sign: Self) -> Self = Copysign: Scalar(Intrinsic::Copysign);
        fn __b_modulus(self) -> Self = Modulus: Scalar(Intrinsic::Abs);
        fn __b_to_bits(self) -> Self::Bits = ToBits: Scalar(Intrinsic::ToBits);
        fn __b_raw_bits(self) -> Self::Bits = RawBits: Scalar(Intrinsic::RawBits);
        fn __b_from_bits(_bits: Self::Bits) -> Self = FromBits: Scalar(Intrinsic::FromBits);
        fn __b_as_f64(self) -> f64 = AsF64: AsF64;
    }
    /// Methods of numbers that are ordered.
    pub trait OrderBuiltins: Sized {
        fn __b_abs(self) -> Self = <Abs>;
        fn __b_min(self, _other: Self) -> Self = <Min>;
        fn __b_max(self, _other: Self) -> Self = <Max>;
        fn __b_clamp(self, _low: Self, _high: Self) -> Self = <Clamp>;
    }
    /// Conversions of numbers to and from bytes.
    pub trait BytesBuiltins: Sized {
        type Bytes;
        fn __b_to_le_bytes(self) -> Self::Bytes = <ToLe>;
        fn __b_to_be_bytes(self) -> Self::Bytes = <ToBe>;
        fn __b_from_le_bytes(_bytes: Self::Bytes) -> Self = <FromLe>;
        fn __b_from_be_bytes(_bytes: Self::Bytes) -> Self = <FromBe>;
    }
    /// Methods of characters, whose functions take the code point.
    impl[] CharBuiltins for char {
        fn __b_is_ascii(&self) -> bool = [ascii::is_ascii];
        fn __b_is_digit(self, _base: u32) -> bool = [ascii::is_digit_of];
        fn __b_to_digit(self, _base: u32) -> Option<u32> = [ascii::to_digit];
        fn __b_from_digit(_value: u32, _base: u32) -> Option<Self> = [ascii::from_digit];
        fn __b_from_u32(_code: u32) -> Option<Self> = [ascii::from_code];
    }
    /// Conversions without loss, and those of authors' types.
    #[diagnostic::on_unimplemented(
        message = "`{Self}::from` does not accept a `{T}`",
        label = "unsupported conversion",
        note = "mark the `impl From<{T}>` block of your own type `#[data]`"
    )]
    pub trait FromBuiltin[T]: Sized {
        /// Marker of the function.
        type Marker: Callee;
        fn __b_from(_value: T) -> Self = [Self::Marker];
    }
    /// Companion of `x.into()`.
    pub trait IntoBuiltin[U: FromBuiltin<Self>]: Sized {
        fn __b_into(self) -> U = [U::Marker];
    }
    /// Conversions that may fail: of integers, and those of authors' types.
    #[diagnostic::on_unimplemented(
        message = "`{Self}::try_from` does not accept a `{T}`",
        label = "unsupported conversion",
        note = "write `{Self}::from(x)` where every value fits; a value of that type needs no conversion"
    )]
    pub trait TryFromBuiltin[T]: Sized {
        /// Marker of the function.
        type Marker: Callee;
        /// Error type.
        type Error: Value;
        fn __b_try_from(_value: T) -> Result<Self, Self::Error> = [Self::Marker];
    }
    /// Companion of `x.try_into()`.
    pub trait TryIntoBuiltin[U: TryFromBuiltin<Self>]: Sized {
        fn __b_try_into(self) -> Result<U, U::Error> = [U::Marker];
    }
}

impl<T, U: FromBuiltin<T>> IntoBuiltin<U> for T {}

/// Each type is its own conversion, as in core.
impl<T> FromBuiltin<T> for T {
    type Marker = Same;
}

impl<T, U: TryFromBuiltin<T>> TryIntoBuiltin<U> for T {}

/// Defines the functions of each integer type.
macro_rules! integers {
    ($(
        $int:ident: $unsigned:ident $pow:ident $wrapping_pow:ident,
            $add:ident $sub:ident $mul:ident $div:ident $rem:ident $neg:ident $shl:ident $shr:ident $checked_pow:ident;
    )*) => {$(
        impl IntegerBuiltins for $int {
            type Unsigned = $unsigned;
            type Pow = integer::$pow;
            type WrappingPow = integer::$wrapping_pow;
            type CheckedAdd = checked::$add;
            type CheckedSub = checked::$sub;
            type CheckedMul = checked::$mul;
            type CheckedDiv = checked::$div;
            type CheckedRem = checked::$rem;
            type CheckedNeg = checked::$neg;
            type CheckedShl = checked::$shl;
            type CheckedShr = checked::$shr;
            type CheckedPow = checked::$checked_pow;
        }
    )*};
}

integers! {
    i8: u8 pow_i8 wrapping_pow_i8, add_i8 sub_i8 mul_i8 div_i8 rem_i8 neg_i8 shl_i8 shr_i8 pow_i8;
    i16: u16 pow_i16 wrapping_pow_i16, add_i16 sub_i16 mul_i16 div_i16 rem_i16 neg_i16 shl_i16 shr_i16 pow_i16;
    i32: u32 pow_i32 wrapping_pow_i32, add_i32 sub_i32 mul_i32 div_i32 rem_i32 neg_i32 shl_i32 shr_i32 pow_i32;
    i64: u64 pow_i64 wrapping_pow_i64, add_i64 sub_i64 mul_i64 div_i64 rem_i64 neg_i64 shl_i64 shr_i64 pow_i64;
    isize: usize pow_isize wrapping_pow_isize, add_isize sub_isize mul_isize div_isize rem_isize neg_isize shl_isize shr_isize pow_isize;
    u8: u8 pow_u8 wrapping_pow_u8, add_u8 sub_u8 mul_u8 div_u8 rem_u8 neg_u8 shl_u8 shr_u8 pow_u8;
    u16: u16 pow_u16 wrapping_pow_u16, add_u16 sub_u16 mul_u16 div_u16 rem_u16 neg_u16 shl_u16 shr_u16 pow_u16;
    u32: u32 pow_u32 wrapping_pow_u32, add_u32 sub_u32 mul_u32 div_u32 rem_u32 neg_u32 shl_u32 shr_u32 pow_u32;
    u64: u64 pow_u64 wrapping_pow_u64, add_u64 sub_u64 mul_u64 div_u64 rem_u64 neg_u64 shl_u64 shr_u64 pow_u64;
    usize: usize pow_usize wrapping_pow_usize, add_usize sub_usize mul_usize div_usize rem_usize neg_usize shl_usize shr_usize pow_usize;
}

/// Writes companions for each signed integer.
macro_rules! signed {
    ($($int:ident $neg:ident $abs:ident;)*) => {$(
        impl SignedBuiltins for $int {
            type CheckedAbs = checked::$abs;
            type SaturatingNeg = integer::$neg;
            type SaturatingAbs = integer::$abs;
        }
    )*};
}

signed! {
    i8 neg_i8 abs_i8;
    i16 neg_i16 abs_i16;
    i32 neg_i32 abs_i32;
    i64 neg_i64 abs_i64;
    isize neg_isize abs_isize;
}

/// Writes companions for each unsigned integer.
macro_rules! unsigned {
    ($($int:ident $signed:ident $add:ident $saturating_add:ident $wrapping_add:ident;)*) => {$(
        impl UnsignedBuiltins for $int {
            type Signed = $signed;
            type CheckedAddSigned = checked::$add;
            type SaturatingAddSigned = integer::$saturating_add;
            type WrappingAddSigned = integer::$wrapping_add;
        }
    )*};
}

unsigned! {
    u8 i8 add_signed_u8 saturating_add_signed_u8 wrapping_add_signed_u8;
    u16 i16 add_signed_u16 saturating_add_signed_u16 wrapping_add_signed_u16;
    u32 i32 add_signed_u32 saturating_add_signed_u32 wrapping_add_signed_u32;
    u64 i64 add_signed_u64 saturating_add_signed_u64 wrapping_add_signed_u64;
    usize isize add_signed_usize saturating_add_signed_usize wrapping_add_signed_usize;
}

impl FloatBuiltins for f64 {
    type Bits = u64;
}

impl FloatBuiltins for f32 {
    type Bits = u32;
}

macro_rules! implement {
    ($($name:ident: $($ty:ident)*;)*) => { $($(impl $name for $ty {})*)* };
}

implement! {
    WholeCompanions: i8 i16 i32 i64 isize u8 u16 u32 u64 usize;
}

macro_rules! ordered {
    ($($ty:ident)*) => {$(
        impl OrderBuiltins for $ty {
            type Abs = Abs;
            type Min = Min;
            type Max = Max;
            type Clamp = Clamp;
        }

        impl DivisionBuiltins for $ty {
            type DivEuclid = DivEuclid;
            type RemEuclid = RemEuclid;
        }
    )*};
}

ordered! { i8 i16 i32 i64 isize u8 u16 u32 u64 usize f32 f64 }

macro_rules! with_sign {
    ($($ty:ident)*) => {$(
        impl SignBuiltins for $ty {
            type Signum = Signum;
        }
    )*};
}

with_sign! { i8 i16 i32 i64 isize f32 f64 }

macro_rules! bytes {
    ($($count:literal: $($ty:ident)*;)*) => {$($(
        impl BytesBuiltins for $ty {
            type Bytes = [u8; $count];
            type ToLe = Little;
            type ToBe = Big;
            type FromLe = Little;
            type FromBe = Big;
        }
    )*)*};
}

bytes! {
    1: i8 u8;
    2: i16 u16;
    4: i32 u32 f32;
    8: i64 u64 isize usize f64;
}

/// Defines the conversions by `from`, with their functions.
macro_rules! converts {
    ($([$($g:tt)*] $from:ty => $to:ty: $marker:ty;)*) => {$(
        impl<$($g)*> FromBuiltin<$from> for $to {
            type Marker = $marker;
        }
    )*};
}
pub(super) use converts;

macro_rules! conversions {
    ($($to:ident: $($from:ident)*;)*) => { $(converts! { $([] $from => $to: From;)* })* };
}

conversions! {
    i8: bool;
    i16: bool i8 u8;
    i32: bool i8 i16 u8 u16;
    i64: bool i8 i16 i32 u8 u16 u32;
    isize: bool i8 i16 u8;
    u8: bool;
    u16: bool u8;
    u32: bool u8 u16 char;
    u64: bool u8 u16 u32;
    usize: bool u8 u16;
    f32: i8 i16 u8 u16;
    f64: i8 i16 i32 u8 u16 u32 f32;
    // Bytes as characters, and characters as their code points.
    char: u8;
}

macro_rules! narrowings {
    ($($to:ident: $($from:ident)*;)*) => { $($(impl TryFromBuiltin<$from> for $to {
        type Marker = TryFrom;
        type Error = TryFromIntError;
    })*)* };
}

narrowings! {
    i8: i16 i32 i64 isize u8 u16 u32 u64 usize;
    i16: i32 i64 isize u16 u32 u64 usize;
    i32: i64 isize u32 u64 usize;
    i64: isize u64 usize;
    isize: i32 i64 u16 u32 u64 usize;
    u8: i8 i16 i32 i64 isize u16 u32 u64 usize;
    u16: i8 i16 i32 i64 isize u32 u64 usize;
    u32: i8 i16 i32 i64 isize u64 usize;
    u64: i8 i16 i32 i64 isize usize;
    usize: i8 i16 i32 i64 isize u32 u64;
}

// That a number does not fit says nothing more: in the C it takes no room.
dsl_types! {
    [] [] TryFromIntError as Self => |_| Ty::Unit;
}

/// Writes companions of `u8` and `char` for letters and digits.
macro_rules! letters {
    ($($kind:ident $companion:ident: $of_byte:ident $of_char:ident -> $result:ty;)*) => {
        companions! {
            /// Methods of bytes and of characters.
            pub trait ByteBuiltins: Sized {
                $(fn $companion(&self) -> $result = <$kind>;)*
            }
        }
        impl ByteBuiltins for u8 {
            $(type $kind = ascii::$of_byte;)*
        }
        impl ByteBuiltins for char {
            $(type $kind = ascii::$of_char;)*
        }
    };
}

letters! {
    Digit __b_is_ascii_digit: is_digit char_is_digit -> bool;
    Hexdigit __b_is_ascii_hexdigit: is_hexdigit char_is_hexdigit -> bool;
    Uppercase __b_is_ascii_uppercase: is_uppercase char_is_uppercase -> bool;
    Lowercase __b_is_ascii_lowercase: is_lowercase char_is_lowercase -> bool;
    Alphabetic __b_is_ascii_alphabetic: is_alphabetic char_is_alphabetic -> bool;
    Alphanumeric __b_is_ascii_alphanumeric: is_alphanumeric char_is_alphanumeric -> bool;
    Whitespace __b_is_ascii_whitespace: is_whitespace char_is_whitespace -> bool;
    ToUppercase __b_to_ascii_uppercase: to_uppercase char_to_uppercase -> Self;
    ToLowercase __b_to_ascii_lowercase: to_lowercase char_to_lowercase -> Self;
}
