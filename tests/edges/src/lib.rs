//! One function for each operation and each type of number.
//!
//! The table of edge values (`tests/tests/edges.rs`) calls every one natively, in the interpreter and as
//! C. A function that is added here is compared from then on.

#![no_std]
#![allow(missing_docs, clippy::all)]

use bessemer::Plain;

/// Gives the words of a call's operands, one after another.
pub type Words<'a> = &'a mut dyn FnMut() -> u64;

/// A function of the table: where it stands, and how it is called natively.
pub struct Case {
    /// The module, `of_i32`.
    pub module: &'static str,
    /// The function, `add`.
    pub name: &'static str,
    /// Its types, the result last.
    pub types: &'static [&'static str],
    /// The word of the result.
    pub call: fn(Words<'_>) -> u64,
}

/// The word of a scalar.
pub fn word(value: &impl Plain) -> u64 {
    let mut word = 0;
    value.store(&mut |it| word = it);
    word
}

macro_rules! cases {
    ($($name:ident($($operand:ident: $ty:ident),*) -> $result:ident $body:block)*) => {
        $(
            #[bessemer::function]
            pub fn $name($($operand: $ty),*) -> $result $body
        )*

        bessemer::__natively! {
            /// The functions of this module.
            pub const CASES: &[crate::Case] = &[$(crate::Case {
                module: module_path!(),
                name: stringify!($name),
                types: &[$(stringify!($ty),)* stringify!($result)],
                call: |next| {
                    $(let $operand = <$ty as bessemer::Plain>::load(next);)*
                    let _ = &next;
                    crate::word(&$name($($operand),*))
                },
            }),*];
        }
    };
}

macro_rules! integers {
    ($($module:ident, $t:ident, $unsigned:ident;)*) => {$(
        pub mod $module {
            cases! {
                add(a: $t, b: $t) -> $t { a + b }
                sub(a: $t, b: $t) -> $t { a - b }
                mul(a: $t, b: $t) -> $t { a * b }
                div(a: $t, b: $t) -> $t { a / b }
                rem(a: $t, b: $t) -> $t { a % b }
                bit_and(a: $t, b: $t) -> $t { a & b }
                bit_or(a: $t, b: $t) -> $t { a | b }
                bit_xor(a: $t, b: $t) -> $t { a ^ b }
                equal(a: $t, b: $t) -> bool { a == b }
                unequal(a: $t, b: $t) -> bool { a != b }
                less(a: $t, b: $t) -> bool { a < b }
                at_most(a: $t, b: $t) -> bool { a <= b }
                more(a: $t, b: $t) -> bool { a > b }
                at_least(a: $t, b: $t) -> bool { a >= b }
                shl_by_u8(a: $t, b: u8) -> $t { a << b }
                shr_by_u8(a: $t, b: u8) -> $t { a >> b }
                shl_by_u32(a: $t, b: u32) -> $t { a << b }
                shr_by_u32(a: $t, b: u32) -> $t { a >> b }
                shl_by_u64(a: $t, b: u64) -> $t { a << b }
                shr_by_u64(a: $t, b: u64) -> $t { a >> b }
                shl_by_i32(a: $t, b: i32) -> $t { a << b }
                shr_by_i32(a: $t, b: i32) -> $t { a >> b }
                shl_by_i8(a: $t, b: i8) -> $t { a << b }
                shr_by_i8(a: $t, b: i8) -> $t { a >> b }
                shl(a: $t, b: $t) -> $t { a << b }
                shr(a: $t, b: $t) -> $t { a >> b }
                not(a: $t) -> $t { !a }
                of_min(a: $t, b: $t) -> $t { a.min(b) }
                of_max(a: $t, b: $t) -> $t { a.max(b) }
                wrapping_add(a: $t, b: $t) -> $t { a.wrapping_add(b) }
                wrapping_sub(a: $t, b: $t) -> $t { a.wrapping_sub(b) }
                wrapping_mul(a: $t, b: $t) -> $t { a.wrapping_mul(b) }
                wrapping_div(a: $t, b: $t) -> $t { a.wrapping_div(b) }
                wrapping_rem(a: $t, b: $t) -> $t { a.wrapping_rem(b) }
                saturating_add(a: $t, b: $t) -> $t { a.saturating_add(b) }
                saturating_sub(a: $t, b: $t) -> $t { a.saturating_sub(b) }
                saturating_mul(a: $t, b: $t) -> $t { a.saturating_mul(b) }
                div_euclid(a: $t, b: $t) -> $t { a.div_euclid(b) }
                rem_euclid(a: $t, b: $t) -> $t { a.rem_euclid(b) }
                abs_diff(a: $t, b: $t) -> $unsigned { a.abs_diff(b) }
                wrapping_shl(a: $t, b: u32) -> $t { a.wrapping_shl(b) }
                wrapping_shr(a: $t, b: u32) -> $t { a.wrapping_shr(b) }
                rotate_left(a: $t, b: u32) -> $t { a.rotate_left(b) }
                rotate_right(a: $t, b: u32) -> $t { a.rotate_right(b) }
                pow(a: $t, b: u32) -> $t { a.pow(b) }
                wrapping_pow(a: $t, b: u32) -> $t { a.wrapping_pow(b) }
                square(a: $t) -> $t { a.pow(2) }
                wrapping_cube(a: $t) -> $t { a.wrapping_pow(3) }
                rotate_three(a: $t) -> $t { a.rotate_left(3) }
                rotate_back(a: $t) -> $t { a.rotate_right(11) }
                shl_eleven(a: $t) -> $t { a.wrapping_shl(11) }
                wrapping_neg(a: $t) -> $t { a.wrapping_neg() }
                swap_bytes(a: $t) -> $t { a.swap_bytes() }
                count_ones(a: $t) -> u32 { a.count_ones() }
                count_zeros(a: $t) -> u32 { a.count_zeros() }
                leading_zeros(a: $t) -> u32 { a.leading_zeros() }
                leading_ones(a: $t) -> u32 { a.leading_ones() }
                trailing_zeros(a: $t) -> u32 { a.trailing_zeros() }
                trailing_ones(a: $t) -> u32 { a.trailing_ones() }
                through_little(a: $t) -> $t { <$t>::from_le_bytes(a.to_le_bytes()) }
                turned(a: $t) -> $t { <$t>::from_be_bytes(a.to_le_bytes()) }
                clamp(a: $t, b: $t, c: $t) -> $t { a.clamp(b, c) }
                limits(a: $t) -> $t { if a == <$t>::MAX || a == <$t>::MIN { a } else { a ^ 1 } }
                width(a: $t) -> u32 { if a > 1 { <$t>::BITS } else { 0 } }
                negated(a: $t) -> $t { 0 - a }
                checked_add(a: $t, b: $t) -> $t { a.checked_add(b).unwrap_or(a ^ b) }
                checked_sub(a: $t, b: $t) -> $t { a.checked_sub(b).unwrap_or(a ^ b) }
                checked_mul(a: $t, b: $t) -> $t { a.checked_mul(b).unwrap_or(a ^ b) }
                checked_div(a: $t, b: $t) -> $t { a.checked_div(b).unwrap_or(a ^ b) }
                checked_rem(a: $t, b: $t) -> $t { a.checked_rem(b).unwrap_or(a ^ b) }
                checked_shl(a: $t, b: u32) -> $t { a.checked_shl(b).unwrap_or(a ^ 1) }
                checked_shr(a: $t, b: u32) -> $t { a.checked_shr(b).unwrap_or(a ^ 1) }
                checked_pow(a: $t, b: u32) -> $t { a.checked_pow(b).unwrap_or(a ^ 1) }
                checked_neg(a: $t) -> $t { a.checked_neg().unwrap_or(a ^ 1) }
                complement_below(a: $t, b: $t) -> bool { !a < b }
                complements_equal(a: $t, b: $t) -> bool { !a == !b }
                exclusive_below(a: $t, b: $t) -> bool { a ^ <$t>::MAX < b }
                left_below(a: $t, b: $t) -> bool { <$t>::MAX - a < b }
                reverse_bits(a: $t) -> $t { a.reverse_bits() }
                isqrt(a: $t) -> $t { a.isqrt() }
                saturating_pow(a: $t, b: u32) -> $t { a.saturating_pow(b) }
                saturating_pow_of_few(a: $t, b: u8) -> $t { a.saturating_pow(u32::from(b & 15)) }
                saturating_div(a: $t, b: $t) -> $t { a.saturating_div(b) }
                overflowing_neg(a: $t) -> $t { match a.overflowing_neg() { (less, true) => less ^ 1, (less, false) => less } }
                checked_div_euclid(a: $t, b: $t) -> $t { a.checked_div_euclid(b).unwrap_or(a ^ b) }
                checked_rem_euclid(a: $t, b: $t) -> $t { a.checked_rem_euclid(b).unwrap_or(a ^ b) }
                ilog10(a: $t) -> u32 { a.ilog10() }
                checked_ilog10(a: $t) -> u32 { a.checked_ilog10().unwrap_or(77) }
                unbounded_shl(a: $t, b: u32) -> $t { a.unbounded_shl(b) }
                unbounded_shr(a: $t, b: u32) -> $t { a.unbounded_shr(b) }
                ilog2(a: $t) -> u32 { a.ilog2() }
                checked_ilog2(a: $t) -> u32 { a.checked_ilog2().unwrap_or(99) }
                midpoint(a: $t, b: $t) -> $t { a.midpoint(b) }
                overflowing_add(a: $t, b: $t) -> $t { match a.overflowing_add(b) { (sum, true) => sum ^ 1, (sum, false) => sum } }
                overflowing_shl(a: $t, b: u32) -> $t { match a.overflowing_shl(b) { (bits, true) => !bits, (bits, false) => bits } }
                overflowing_shr(a: $t, b: u32) -> $t { match a.overflowing_shr(b) { (bits, true) => !bits, (bits, false) => bits } }
                little_ended(a: $t) -> $t { <$t>::from_le(a).wrapping_sub(a.to_le()) }
                big_ended(a: $t) -> $t { <$t>::from_be(a) }
                to_big_end(a: $t) -> $t { a.to_be() }
                wrapped(a: $t, b: $t) -> $t { let mut x = core::num::Wrapping(a) * core::num::Wrapping(b) - core::num::Wrapping(b); x += core::num::Wrapping(a); x ^= core::num::Wrapping(b); (!x).0 }
                wrapped_quotient(a: $t, b: $t) -> $t { let mut x = core::num::Wrapping(a) / core::num::Wrapping(b); x /= core::num::Wrapping(3); x |= core::num::Wrapping(b); x &= core::num::Wrapping(a); x.0 }
                wrapped_shift(a: $t, b: u8) -> $t { let mut x = core::num::Wrapping(a) << usize::from(b); x >>= 3; x <<= usize::from(b); (x >> usize::from(b)).0 }
                overflowing_sub(a: $t, b: $t) -> $t { match a.overflowing_sub(b) { (less, true) => less ^ 1, (less, false) => less } }
                overflowing_mul(a: $t, b: $t) -> $t { match a.overflowing_mul(b) { (much, true) => much ^ 1, (much, false) => much } }
                wrapped_below(a: $t, b: $t) -> bool { <$t>::MAX.wrapping_sub(a) < b }
            }
        }
    )*};
}

macro_rules! signed {
    ($($module:ident, $t:ident, $unsigned:ident;)*) => {$(
        pub mod $module {
            cases! {
                neg(a: $t) -> $t { -a }
                of_abs(a: $t) -> $t { a.abs() }
                signum(a: $t) -> $t { a.signum() }
                wrapping_abs(a: $t) -> $t { a.wrapping_abs() }
                checked_abs(a: $t) -> $t { a.checked_abs().unwrap_or(a ^ 1) }
                is_positive(a: $t) -> bool { a.is_positive() }
                is_negative(a: $t) -> bool { a.is_negative() }
                unsigned_abs(a: $t) -> $unsigned { a.unsigned_abs() }
            }
        }
    )*};
}

macro_rules! unsigned {
    ($($module:ident, $t:ident, $signed:ident;)*) => {$(
        pub mod $module {
            cases! {
                div_ceil(a: $t, b: $t) -> $t { a.div_ceil(b) }
                next_multiple_of(a: $t, b: $t) -> $t { a.next_multiple_of(b) }
                is_multiple_of(a: $t, b: $t) -> bool { a.is_multiple_of(b) }
                checked_next_multiple_of(a: $t, b: $t) -> $t { a.checked_next_multiple_of(b).unwrap_or(a ^ b) }
                next_power_of_two(a: $t) -> $t { a.next_power_of_two() }
                checked_next_power_of_two(a: $t) -> $t { a.checked_next_power_of_two().unwrap_or(3) }
                checked_add_signed(a: $t, b: $signed) -> $t { a.checked_add_signed(b).unwrap_or(a ^ 1) }
                saturating_add_signed(a: $t, b: $signed) -> $t { a.saturating_add_signed(b) }
                wrapping_add_signed(a: $t, b: $signed) -> $t { a.wrapping_add_signed(b) }
                is_power_of_two(a: $t) -> bool { a.is_power_of_two() }
                low_product(a: $t, b: $t) -> $t { a.carrying_mul(b, a ^ b).0 }
                high_product(a: $t, b: $t) -> $t { a.carrying_mul(b, b).1 }
            }
        }
    )*};
}

macro_rules! floats {
    ($($module:ident, $t:ident, $bits:ident;)*) => {$(
        pub mod $module {
            cases! {
                add(a: $t, b: $t) -> $t { a + b }
                sub(a: $t, b: $t) -> $t { a - b }
                mul(a: $t, b: $t) -> $t { a * b }
                div(a: $t, b: $t) -> $t { a / b }
                rem(a: $t, b: $t) -> $t { a % b }
                equal(a: $t, b: $t) -> bool { a == b }
                unequal(a: $t, b: $t) -> bool { a != b }
                less(a: $t, b: $t) -> bool { a < b }
                at_most(a: $t, b: $t) -> bool { a <= b }
                more(a: $t, b: $t) -> bool { a > b }
                at_least(a: $t, b: $t) -> bool { a >= b }
                of_min(a: $t, b: $t) -> $t { a.min(b) }
                of_max(a: $t, b: $t) -> $t { a.max(b) }
                of_copysign(a: $t, b: $t) -> $t { a.copysign(b) }
                of_div_euclid(a: $t, b: $t) -> $t { a.div_euclid(b) }
                of_rem_euclid(a: $t, b: $t) -> $t { a.rem_euclid(b) }
                of_atan2(a: $t, b: $t) -> $t { a.atan2(b) }
                neg(a: $t) -> $t { -a }
                of_sqrt(a: $t) -> $t { a.sqrt() }
                of_abs(a: $t) -> $t { a.abs() }
                of_floor(a: $t) -> $t { a.floor() }
                of_ceil(a: $t) -> $t { a.ceil() }
                of_trunc(a: $t) -> $t { a.trunc() }
                of_round(a: $t) -> $t { a.round() }
                of_fract(a: $t) -> $t { a.fract() }
                of_signum(a: $t) -> $t { a.signum() }
                of_recip(a: $t) -> $t { a.recip() }
                of_to_degrees(a: $t) -> $t { a.to_degrees() }
                of_to_radians(a: $t) -> $t { a.to_radians() }
                of_sin(a: $t) -> $t { a.sin() }
                of_cos(a: $t) -> $t { a.cos() }
                of_tan(a: $t) -> $t { a.tan() }
                of_asin(a: $t) -> $t { a.asin() }
                of_acos(a: $t) -> $t { a.acos() }
                of_atan(a: $t) -> $t { a.atan() }
                of_exp(a: $t) -> $t { a.exp() }
                of_exp2(a: $t) -> $t { a.exp2() }
                of_exp_m1(a: $t) -> $t { a.exp_m1() }
                of_ln(a: $t) -> $t { a.ln() }
                of_log2(a: $t) -> $t { a.log2() }
                of_log10(a: $t) -> $t { a.log10() }
                of_ln_1p(a: $t) -> $t { a.ln_1p() }
                of_sinh(a: $t) -> $t { a.sinh() }
                of_cosh(a: $t) -> $t { a.cosh() }
                of_tanh(a: $t) -> $t { a.tanh() }
                of_cbrt(a: $t) -> $t { a.cbrt() }
                of_powf(a: $t, b: $t) -> $t { a.powf(b) }
                of_powi(a: $t, b: i32) -> $t { a.powi(b) }
                of_hypot(a: $t, b: $t) -> $t { a.hypot(b) }
                is_nan(a: $t) -> bool { a.is_nan() }
                is_finite(a: $t) -> bool { a.is_finite() }
                is_infinite(a: $t) -> bool { a.is_infinite() }
                is_sign_negative(a: $t) -> bool { a.is_sign_negative() }
                is_sign_positive(a: $t) -> bool { a.is_sign_positive() }
                to_bits(a: $t) -> $bits { a.to_bits() }
                from_bits(a: $bits) -> $t { <$t>::from_bits(a) }
                through_bytes(a: $t) -> $t { <$t>::from_be_bytes(a.to_be_bytes()) }
                clamp(a: $t, b: $t, c: $t) -> $t { a.clamp(b, c) }
                limits(a: $t) -> $t { if a >= <$t>::MAX || a <= <$t>::MIN || a < <$t>::EPSILON { a } else { 0.0 } }
            }
        }
    )*};
}

macro_rules! conversions {
    ($($module:ident, $t:ident;)*) => {$(
        pub mod $module {
            cases! {
                as_i8(a: $t) -> i8 { a as i8 }
                as_i16(a: $t) -> i16 { a as i16 }
                as_i32(a: $t) -> i32 { a as i32 }
                as_i64(a: $t) -> i64 { a as i64 }
                as_isize(a: $t) -> isize { a as isize }
                as_u8(a: $t) -> u8 { a as u8 }
                as_u16(a: $t) -> u16 { a as u16 }
                as_u32(a: $t) -> u32 { a as u32 }
                as_u64(a: $t) -> u64 { a as u64 }
                as_usize(a: $t) -> usize { a as usize }
                as_f32(a: $t) -> f32 { a as f32 }
                as_f64(a: $t) -> f64 { a as f64 }
            }
        }
    )*};
}

pub mod lossless {
    cases! {
        i16_of_i8(a: i8) -> i16 { i16::from(a) }
        i16_of_u8(a: u8) -> i16 { i16::from(a) }
        i32_of_i8(a: i8) -> i32 { i32::from(a) }
        i32_of_i16(a: i16) -> i32 { i32::from(a) }
        i32_of_u8(a: u8) -> i32 { i32::from(a) }
        i32_of_u16(a: u16) -> i32 { i32::from(a) }
        i64_of_i8(a: i8) -> i64 { i64::from(a) }
        i64_of_i16(a: i16) -> i64 { i64::from(a) }
        i64_of_i32(a: i32) -> i64 { i64::from(a) }
        i64_of_u8(a: u8) -> i64 { i64::from(a) }
        i64_of_u16(a: u16) -> i64 { i64::from(a) }
        i64_of_u32(a: u32) -> i64 { i64::from(a) }
        isize_of_i16(a: i16) -> isize { isize::from(a) }
        isize_of_u8(a: u8) -> isize { isize::from(a) }
        u8_of_bool(a: bool) -> u8 { u8::from(a) }
        u16_of_u8(a: u8) -> u16 { u16::from(a) }
        u16_of_bool(a: bool) -> u16 { u16::from(a) }
        u32_of_u8(a: u8) -> u32 { u32::from(a) }
        u32_of_u16(a: u16) -> u32 { u32::from(a) }
        u32_of_bool(a: bool) -> u32 { u32::from(a) }
        u64_of_u8(a: u8) -> u64 { u64::from(a) }
        u64_of_u16(a: u16) -> u64 { u64::from(a) }
        u64_of_u32(a: u32) -> u64 { u64::from(a) }
        u64_of_bool(a: bool) -> u64 { u64::from(a) }
        usize_of_u8(a: u8) -> usize { usize::from(a) }
        usize_of_u16(a: u16) -> usize { usize::from(a) }
        usize_of_bool(a: bool) -> usize { usize::from(a) }
        f32_of_i8(a: i8) -> f32 { f32::from(a) }
        f32_of_i16(a: i16) -> f32 { f32::from(a) }
        f32_of_u8(a: u8) -> f32 { f32::from(a) }
        f32_of_u16(a: u16) -> f32 { f32::from(a) }
        f64_of_i8(a: i8) -> f64 { f64::from(a) }
        f64_of_i16(a: i16) -> f64 { f64::from(a) }
        f64_of_i32(a: i32) -> f64 { f64::from(a) }
        f64_of_u8(a: u8) -> f64 { f64::from(a) }
        f64_of_u16(a: u16) -> f64 { f64::from(a) }
        f64_of_u32(a: u32) -> f64 { f64::from(a) }
        f64_of_f32(a: f32) -> f64 { f64::from(a) }
    }
}

pub mod of_bool {
    cases! {
        both(a: bool, b: bool) -> bool { a && b }
        either(a: bool, b: bool) -> bool { a || b }
        bit_and(a: bool, b: bool) -> bool { a & b }
        bit_or(a: bool, b: bool) -> bool { a | b }
        bit_xor(a: bool, b: bool) -> bool { a ^ b }
        equal(a: bool, b: bool) -> bool { a == b }
        unequal(a: bool, b: bool) -> bool { a != b }
        less(a: bool, b: bool) -> bool { a < b }
        at_most(a: bool, b: bool) -> bool { a <= b }
        more(a: bool, b: bool) -> bool { a > b }
        at_least(a: bool, b: bool) -> bool { a >= b }
        not(a: bool) -> bool { !a }
        as_i8(a: bool) -> i8 { a as i8 }
        as_i16(a: bool) -> i16 { a as i16 }
        as_i32(a: bool) -> i32 { a as i32 }
        as_i64(a: bool) -> i64 { a as i64 }
        as_isize(a: bool) -> isize { a as isize }
        as_u8(a: bool) -> u8 { a as u8 }
        as_u16(a: bool) -> u16 { a as u16 }
        as_u32(a: bool) -> u32 { a as u32 }
        as_u64(a: bool) -> u64 { a as u64 }
        as_usize(a: bool) -> usize { a as usize }
    }
}

integers! {
    of_i8, i8, u8;
    of_i16, i16, u16;
    of_i32, i32, u32;
    of_i64, i64, u64;
    of_isize, isize, usize;
    of_u8, u8, u8;
    of_u16, u16, u16;
    of_u32, u32, u32;
    of_u64, u64, u64;
    of_usize, usize, usize;
}

signed! {
    signed_i8, i8, u8;
    signed_i16, i16, u16;
    signed_i32, i32, u32;
    signed_i64, i64, u64;
    signed_isize, isize, usize;
}

unsigned! {
    unsigned_u8, u8, i8;
    unsigned_u16, u16, i16;
    unsigned_u32, u32, i32;
    unsigned_u64, u64, i64;
    unsigned_usize, usize, isize;
}

floats! {
    of_f32, f32, u32;
    of_f64, f64, u64;
}

conversions! {
    from_i8, i8;
    from_i16, i16;
    from_i32, i32;
    from_i64, i64;
    from_isize, isize;
    from_u8, u8;
    from_u16, u16;
    from_u32, u32;
    from_u64, u64;
    from_usize, usize;
    from_f32, f32;
    from_f64, f64;
}

bessemer::__natively! {
    /// Every function of the table.
    pub const CASES: &[&[Case]] = &[
        lossless::CASES,
        of_bool::CASES,
        of_f32::CASES,
        of_f64::CASES,
        of_i8::CASES,
        of_i16::CASES,
        of_i32::CASES,
        of_i64::CASES,
        of_isize::CASES,
        of_u8::CASES,
        of_u16::CASES,
        of_u32::CASES,
        of_u64::CASES,
        of_usize::CASES,
        signed_i8::CASES,
        signed_i16::CASES,
        signed_i32::CASES,
        signed_i64::CASES,
        signed_isize::CASES,
        unsigned_u8::CASES,
        unsigned_u16::CASES,
        unsigned_u32::CASES,
        unsigned_u64::CASES,
        unsigned_usize::CASES,
        from_i8::CASES,
        from_i16::CASES,
        from_i32::CASES,
        from_i64::CASES,
        from_isize::CASES,
        from_u8::CASES,
        from_u16::CASES,
        from_u32::CASES,
        from_u64::CASES,
        from_usize::CASES,
        from_f32::CASES,
        from_f64::CASES,
    ];
}
