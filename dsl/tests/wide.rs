//! The functions that compute with integers of 128 bits in the C have the values of Rust's own.

use bessemer::wide::i128::{self as signed, I128};
use bessemer::wide::u128::{self as unsigned, U128};

/// The words of numbers, of pairs with a truth, and of what may be absent.
trait Words {
    type Of;
    fn words(self) -> Self::Of;
}

impl Words for u128 {
    type Of = U128;
    fn words(self) -> U128 {
        U128 { high: (self >> 64) as u64, low: self as u64 }
    }
}

impl Words for i128 {
    type Of = I128;
    fn words(self) -> I128 {
        I128 { high: (self >> 64) as i64, low: self as u64 }
    }
}

impl<T: Words> Words for (T, bool) {
    type Of = (T::Of, bool);
    fn words(self) -> Self::Of {
        (self.0.words(), self.1)
    }
}

impl<T: Words> Words for Option<T> {
    type Of = Option<T::Of>;
    fn words(self) -> Self::Of {
        self.map(T::words)
    }
}

/// Numbers at which carries, borrows, halves and quotients change.
fn edges() -> Vec<u128> {
    let words = [
        0,
        1,
        2,
        3,
        10,
        0x7FFF_FFFF,
        0x8000_0000,
        0xFFFF_FFFF,
        0x1_0000_0000,
        0x1_0000_0001,
        0x0123_4567_89AB_CDEF,
        0x7FFF_FFFF_FFFF_FFFF,
        0x8000_0000_0000_0000,
        0x8000_0000_0000_0001,
        0xFFFF_FFFF_0000_0000,
        0xFFFF_FFFF_FFFF_FFFE,
        u64::MAX,
    ];
    words
        .iter()
        .flat_map(|&high| words.map(|low| u128::from(high) << 64 | u128::from(low)))
        .collect()
}

/// Pseudo-random numbers of all lengths.
fn random() -> impl Iterator<Item = u128> {
    let mut seed = 1_u64;
    std::iter::repeat_with(move || {
        let mut word = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            seed ^ seed >> 29
        };
        let (high, low, bits) = (word(), word(), word() >> 57);
        (u128::from(high) << 64 | u128::from(low)) >> bits
    })
}

/// Compares functions of two numbers with Rust's methods of the same names.
macro_rules! same {
    ($module:ident($one:ident, $other:ident): $($name:ident)*) => {$(
        let ours = $module::$name($one.words(), $other.words());
        assert_eq!(ours, $one.$name($other).words(), "{} {} {}", $one, stringify!($name), $other);
    )*};
}

/// Compares functions of a number.
macro_rules! alike {
    ($module:ident($one:ident): $($name:ident)*) => {$(
        let ours = $module::$name($one.words());
        assert_eq!(ours, $one.$name(), "{} {}", $one, stringify!($name));
    )*};
}

/// Compares functions of a number and a number of bits.
macro_rules! moved {
    ($module:ident($one:ident, $bits:ident): $($name:ident)*) => {$(
        let ours = $module::$name($one.words(), $bits);
        assert_eq!(ours, $one.$name($bits).words(), "{} {} {}", $one, stringify!($name), $bits);
    )*};
}

/// Compares conversions by `as` and `try_from`.
macro_rules! converted {
    ($module:ident($one:ident): $($int:ident $to:ident $try_to:ident,)*) => {$(
        assert_eq!($module::$to($one.words()), $one as $int, "{} as {}", $one, stringify!($int));
        assert_eq!($module::$try_to($one.words()), <$int>::try_from($one).map_err(drop), "{}", $one);
    )*};
}

macro_rules! both {
    ($module:ident: $wide:ident, $one:ident, $other:ident) => {
        same!($module($one, $other): wrapping_add wrapping_sub wrapping_mul checked_add checked_sub checked_mul
            checked_div checked_rem overflowing_add overflowing_sub overflowing_mul saturating_add saturating_sub
            saturating_mul abs_diff);
        let bits = $other as u32;
        moved!($module($one, bits): wrapping_shl wrapping_shr checked_shl checked_shr rotate_left rotate_right
            wrapping_pow);
        alike!($module($one): count_ones count_zeros leading_zeros leading_ones trailing_zeros trailing_ones
            to_le_bytes to_be_bytes);
        assert_eq!($module::swap_bytes($one.words()), $one.swap_bytes().words());
        assert_eq!($module::checked_neg($one.words()), $one.checked_neg().words());
        assert_eq!($module::from_le_bytes($one.to_le_bytes()), $one.words());
        assert_eq!($module::from_be_bytes($one.to_be_bytes()), $one.words());
        converted!($module($one): i8 to_i8 try_to_i8, i16 to_i16 try_to_i16, i32 to_i32 try_to_i32,
            i64 to_i64 try_to_i64, u8 to_u8 try_to_u8, u16 to_u16 try_to_u16, u32 to_u32 try_to_u32,
            u64 to_u64 try_to_u64,);
        let exponent = bits & 7;
        if let Some(power) = $one.checked_pow(exponent) {
            assert_eq!($module::pow($one.words(), exponent), power.words());
        }
        assert_eq!($one.words() < $other.words(), $one < $other);
        for near in [$module::to_f64($one.words()), $other as f64, f64::from_bits($one as u64)] {
            assert_eq!($module::of_f64(near), (near as $wide).words(), "{near}");
        }
        assert_eq!($module::to_f64($one.words()), $one as f64, "{}", $one);
        assert_eq!($module::to_f32($one.words()), $one as f32, "{}", $one);
        let single = f32::from_bits($other as u32);
        assert_eq!($module::of_f32(single), (single as $wide).words(), "{single}");
    };
}

fn check(one: u128, other: u128) {
    both!(unsigned: u128, one, other);
    assert_eq!(unsigned::checked_ilog2(one.words()), one.checked_ilog2());
    assert_eq!(unsigned::is_power_of_two(one.words()), one.is_power_of_two());
    let (a, b) = (one as u64, other as u64);
    assert_eq!(unsigned::product_of_words(a, b), (u128::from(a) * u128::from(b)).words());
    assert_eq!(unsigned::sum_of_words(a, b), (u128::from(a) + u128::from(b)).words());

    let (one, other) = (one as i128, other as i128);
    both!(signed: i128, one, other);
    assert_eq!(signed::checked_abs(one.words()), one.checked_abs().words());
    assert_eq!(signed::unsigned_abs(one.words()), one.unsigned_abs().words());
    assert_eq!(signed::signum(one.words()), one.signum().words());
    assert_eq!(signed::is_positive(one.words()), one.is_positive());
    if let (Some(quotient), Some(rest)) =
        (one.checked_div_euclid(other), one.checked_rem_euclid(other))
    {
        assert_eq!(
            signed::quotient_euclid(one.words(), other.words()),
            quotient.words(),
            "{one} {other}"
        );
        assert_eq!(
            signed::remainder_euclid(one.words(), other.words()),
            rest.words(),
            "{one} {other}"
        );
    }
    let (a, b) = (one as i64, other as i64);
    assert_eq!(signed::product_of_words(a, b), (i128::from(a) * i128::from(b)).words(), "{a} {b}");
    assert_eq!(signed::sum_of_words(a, b), (i128::from(a) + i128::from(b)).words(), "{a} {b}");
    assert_eq!(
        signed::difference_of_words(a, b),
        (i128::from(a) - i128::from(b)).words(),
        "{a} {b}"
    );
}

#[test]
fn arithmetic_is_that_of_rust() {
    let edges = edges();
    for &one in &edges {
        assert_eq!(unsigned::isqrt(one.words()), one.isqrt().words());
        for &other in &edges {
            check(one, other);
        }
    }
    let mut random = random();
    for _ in 0..50_000 {
        if let (Some(one), Some(other)) = (random.next(), random.next()) {
            check(one, other);
        }
    }
}
