//! The companions of checked arithmetic: functions of [`math::checked`](crate::math::checked).

use super::builder::Callee;
use super::builtin::companions;
use super::slot::Called;
use crate::math::{checked, integer};

companions! {
    /// Checked arithmetic of integers.
    pub trait CheckedBuiltins: Sized {
        type Add: Callee;
        type Sub: Callee;
        type Mul: Callee;
        type Div: Callee;
        type Rem: Callee;
        type Neg: Callee;
        type Shl: Callee;
        type Shr: Callee;
        type Pow: Callee;
        fn __b_checked_add(self, _other: Self) -> Option<Self> = [Self::Add];
        fn __b_checked_sub(self, _other: Self) -> Option<Self> = [Self::Sub];
        fn __b_checked_mul(self, _other: Self) -> Option<Self> = [Self::Mul];
        fn __b_checked_div(self, _other: Self) -> Option<Self> = [Self::Div];
        fn __b_checked_rem(self, _other: Self) -> Option<Self> = [Self::Rem];
        fn __b_checked_neg(self) -> Option<Self> = [Self::Neg];
        fn __b_checked_shl(self, _bits: u32) -> Option<Self> = [Self::Shl];
        fn __b_checked_shr(self, _bits: u32) -> Option<Self> = [Self::Shr];
        fn __b_checked_pow(self, _exponent: u32) -> Option<Self> = [Self::Pow];
    }
    /// The magnitude of signed integers.
    pub trait CheckedAbsBuiltin: Sized {
        type Abs: Callee;
        type SaturatingNeg: Callee;
        type SaturatingAbs: Callee;
        fn __b_checked_abs(self) -> Option<Self> = [Self::Abs];
        fn __b_saturating_neg(self) -> Self = [Self::SaturatingNeg];
        fn __b_saturating_abs(self) -> Self = [Self::SaturatingAbs];
    }
    /// The sum of what has no sign and what has one.
    pub trait CheckedSignedBuiltin[S]: Sized {
        type AddSigned: Callee;
        type SaturatingAddSigned: Callee;
        type WrappingAddSigned: Callee;
        fn __b_checked_add_signed(self, _other: S) -> Option<Self> = [Self::AddSigned];
        fn __b_saturating_add_signed(self, _other: S) -> Self = [Self::SaturatingAddSigned];
        fn __b_wrapping_add_signed(self, _other: S) -> Self = [Self::WrappingAddSigned];
    }
}

macro_rules! checked {
    ($($int:ident: $($operation:ident $function:ident),*;)*) => {$(
        impl CheckedBuiltins for $int {
            $(type $operation = checked::$function;)*
        }
    )*};
}

checked! {
    i8: Add add_i8, Sub sub_i8, Mul mul_i8, Div div_i8, Rem rem_i8, Neg neg_i8, Shl shl_i8, Shr shr_i8, Pow pow_i8;
    i16: Add add_i16, Sub sub_i16, Mul mul_i16, Div div_i16, Rem rem_i16, Neg neg_i16, Shl shl_i16, Shr shr_i16, Pow pow_i16;
    i32: Add add_i32, Sub sub_i32, Mul mul_i32, Div div_i32, Rem rem_i32, Neg neg_i32, Shl shl_i32, Shr shr_i32, Pow pow_i32;
    i64: Add add_i64, Sub sub_i64, Mul mul_i64, Div div_i64, Rem rem_i64, Neg neg_i64, Shl shl_i64, Shr shr_i64, Pow pow_i64;
    isize: Add add_isize, Sub sub_isize, Mul mul_isize, Div div_isize, Rem rem_isize, Neg neg_isize, Shl shl_isize, Shr shr_isize, Pow pow_isize;
    u8: Add add_u8, Sub sub_u8, Mul mul_u8, Div div_u8, Rem rem_u8, Neg neg_u8, Shl shl_u8, Shr shr_u8, Pow pow_u8;
    u16: Add add_u16, Sub sub_u16, Mul mul_u16, Div div_u16, Rem rem_u16, Neg neg_u16, Shl shl_u16, Shr shr_u16, Pow pow_u16;
    u32: Add add_u32, Sub sub_u32, Mul mul_u32, Div div_u32, Rem rem_u32, Neg neg_u32, Shl shl_u32, Shr shr_u32, Pow pow_u32;
    u64: Add add_u64, Sub sub_u64, Mul mul_u64, Div div_u64, Rem rem_u64, Neg neg_u64, Shl shl_u64, Shr shr_u64, Pow pow_u64;
    usize: Add add_usize, Sub sub_usize, Mul mul_usize, Div div_usize, Rem rem_usize, Neg neg_usize, Shl shl_usize, Shr shr_usize, Pow pow_usize;
}

macro_rules! magnitudes {
    ($($int:ident $function:ident $neg:ident $abs:ident;)*) => {$(
        impl CheckedAbsBuiltin for $int {
            type Abs = checked::$function;
            type SaturatingNeg = integer::$neg;
            type SaturatingAbs = integer::$abs;
        }
    )*};
}

magnitudes! {
    i8 abs_i8 neg_i8 abs_i8;
    i16 abs_i16 neg_i16 abs_i16;
    i32 abs_i32 neg_i32 abs_i32;
    i64 abs_i64 neg_i64 abs_i64;
    isize abs_isize neg_isize abs_isize;
}

macro_rules! signed_operands {
    ($($int:ident $signed:ident $function:ident $saturating:ident $wrapping:ident;)*) => {$(
        impl CheckedSignedBuiltin<$signed> for $int {
            type AddSigned = checked::$function;
            type SaturatingAddSigned = integer::$saturating;
            type WrappingAddSigned = integer::$wrapping;
        }
    )*};
}

signed_operands! {
    u8 i8 add_signed_u8 saturating_add_signed_u8 wrapping_add_signed_u8;
    u16 i16 add_signed_u16 saturating_add_signed_u16 wrapping_add_signed_u16;
    u32 i32 add_signed_u32 saturating_add_signed_u32 wrapping_add_signed_u32;
    u64 i64 add_signed_u64 saturating_add_signed_u64 wrapping_add_signed_u64;
    usize isize add_signed_usize saturating_add_signed_usize wrapping_add_signed_usize;
}
