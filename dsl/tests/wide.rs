//! The functions that compute with integers of 128 bits in the C have the values of Rust's own.

use bessemer::wide::u128::{self as unsigned, U128};

fn parts(number: u128) -> U128 {
    U128 { high: (number >> 64) as u64, low: number as u64 }
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

fn check(one: u128, other: u128) {
    let (a, b) = (parts(one), parts(other));
    assert_eq!(unsigned::wrapping_add(a, b), parts(one.wrapping_add(other)), "{one} + {other}");
    assert_eq!(unsigned::wrapping_sub(a, b), parts(one.wrapping_sub(other)), "{one} - {other}");
    assert_eq!(unsigned::wrapping_mul(a, b), parts(one.wrapping_mul(other)), "{one} * {other}");
    assert_eq!(unsigned::sum_overflows(a, b), one.checked_add(other).is_none(), "{one} + {other}");
    assert_eq!(
        unsigned::product_overflows(a, b),
        one.checked_mul(other).is_none(),
        "{one} * {other}"
    );
    assert_eq!(a < b, one < other, "{one} < {other}");
    if other != 0 {
        assert_eq!(unsigned::quotient(a, b), parts(one / other), "{one} / {other}");
        assert_eq!(unsigned::remainder(a, b), parts(one % other), "{one} % {other}");
    }
    let bits = other as u32;
    assert_eq!(unsigned::wrapping_shl(a, bits), parts(one.wrapping_shl(bits)), "{one} << {bits}");
    assert_eq!(unsigned::wrapping_shr(a, bits), parts(one.wrapping_shr(bits)), "{one} >> {bits}");
}

#[test]
fn arithmetic_is_that_of_rust() {
    let edges = edges();
    for &one in &edges {
        for &other in &edges {
            check(one, other);
        }
    }
    let mut random = random();
    for _ in 0..200_000 {
        if let (Some(one), Some(other)) = (random.next(), random.next()) {
            check(one, other);
        }
    }
}
