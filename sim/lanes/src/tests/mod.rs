//! Each operation against Rust's on one number, by bits, on numbers at the edges of their types and in all pairs.

use super::*;

/// Numbers at the edges of double precision, and some between.
const REALS: [f64; 24] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    1.5,
    2.5,
    -2.5,
    0.499_999_999_999_999_94,
    4_503_599_627_370_497.5,
    1e-310,
    -5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    std::f64::consts::PI,
    -1e16,
    255.7,
    -32_768.5,
    1e300,
];

/// Numbers at the edges of integers.
const WHOLES: [i64; 14] = [
    0,
    1,
    -1,
    2,
    7,
    63,
    64,
    255,
    65_535,
    0xffff_ffff,
    -0x8000_0000,
    i64::MAX,
    i64::MIN,
    0x1234_5678_9abc,
];

fn bits(value: f64) -> u64 {
    if value.is_nan() { u64::MAX } else { value.to_bits() }
}

/// Calls `check` with each pair of numbers, in lanes: eight pairs at a time.
fn pairs<T: Copy>(all: &[T], mut check: impl FnMut([T; LANES], [T; LANES])) {
    let pairs: Vec<(T, T)> =
        all.iter().flat_map(|one| all.iter().map(move |other| (*one, *other))).collect();
    for chunk in pairs.chunks(LANES) {
        let at = |lane: usize| chunk[lane.min(chunk.len() - 1)];
        check(std::array::from_fn(|it| at(it).0), std::array::from_fn(|it| at(it).1));
    }
}

#[test]
fn reals_compute_as_rust_does() {
    type Both = (&'static str, fn(Real, Real) -> Real, fn(f64, f64) -> f64);
    let operations: [Both; 19] = [
        ("+", |a, b| a + b, |a, b| a + b),
        ("-", |a, b| a - b, |a, b| a - b),
        ("*", |a, b| a * b, |a, b| a * b),
        ("/", |a, b| a / b, |a, b| a / b),
        ("%", Real::remainder, |a, b| a % b),
        ("neg", |a, _| -a, |a, _| -a),
        ("abs", |a, _| a.abs(), |a, _| a.abs()),
        ("sqrt", |a, _| a.sqrt(), |a, _| a.sqrt()),
        ("floor", |a, _| a.floor(), |a, _| a.floor()),
        ("ceil", |a, _| a.ceil(), |a, _| a.ceil()),
        ("trunc", |a, _| a.trunc(), |a, _| a.trunc()),
        ("round", |a, _| a.round(), |a, _| a.round()),
        ("signum", |a, _| a.signum(), |a, _| a.signum()),
        ("copysign", Real::copysign, |a, b| if b.is_nan() { a.abs() } else { a.copysign(b) }),
        ("min", Real::min, |a, b| least(a, b)),
        ("max", Real::max, |a, b| -least(-a, -b)),
        ("div_euclid", Real::div_euclid, f64::div_euclid),
        ("rem_euclid", Real::rem_euclid, f64::rem_euclid),
        ("f32", |a, _| a.single().real(), |a, _| f64::from(a as f32)),
    ];
    pairs(&REALS, |a, b| {
        for (name, lanes, one) in operations {
            let found = lanes(Real::new(a), Real::new(b)).to_array().map(bits);
            let wanted: [u64; LANES] = std::array::from_fn(|it| bits(one(a[it], b[it])));
            assert_eq!(found, wanted, "{name} of {a:?} and {b:?}");
        }
    });
}

/// Returns the smaller number, where −0 < +0; a NaN is ignored.
fn least(a: f64, b: f64) -> f64 {
    match (a.is_nan(), b.is_nan()) {
        (true, _) => b,
        (_, true) => a,
        _ if a == b => {
            if a.is_sign_negative() {
                a
            } else {
                b
            }
        }
        _ => {
            if a < b {
                a
            } else {
                b
            }
        }
    }
}

#[test]
fn comparisons_and_conversions_are_rusts() {
    type Both = (fn(Real, Real) -> Mask, fn(f64, f64) -> bool);
    let comparisons: [Both; 9] = [
        (Real::lt, |a, b| a < b),
        (Real::le, |a, b| a <= b),
        (Real::gt, |a, b| a > b),
        (Real::ge, |a, b| a >= b),
        (Real::equals, |a, b| a == b),
        (Real::differs, |a, b| a != b),
        (|a, _| a.is_nan(), |a, _| a.is_nan()),
        (|a, _| a.is_finite(), |a, _| a.is_finite()),
        (|a, _| a.is_infinite(), |a, _| a.is_infinite()),
    ];
    pairs(&REALS, |a, b| {
        for (lanes, one) in comparisons {
            let wanted: [bool; LANES] = std::array::from_fn(|it| one(a[it], b[it]));
            assert_eq!(lanes(Real::new(a), Real::new(b)).to_array(), wanted, "{a:?}, {b:?}");
        }
        let found = Real::new(a).convert(|value| value as i16 as i64).to_array();
        assert_eq!(found, a.map(|value| i64::from(value as i16)));
        let clamped = Real::new(a).clamp(Real::of(-1.0), Real::new(b).abs()).to_array().map(bits);
        for lane in (0..LANES).filter(|lane| !b[*lane].is_nan()) {
            assert_eq!(clamped[lane], bits(a[lane].clamp(-1.0, b[lane].abs())));
        }
    });
}

#[test]
fn whole_numbers_compute_as_rust_does() {
    type Both = (&'static str, fn(Whole, Whole) -> Whole, fn(i64, i64) -> i64);
    let operations: [Both; 21] = [
        ("+", |a, b| a + b, i64::wrapping_add),
        ("-", |a, b| a - b, i64::wrapping_sub),
        ("*", |a, b| a * b, i64::wrapping_mul),
        ("&", |a, b| a & b, |a, b| a & b),
        ("|", |a, b| a | b, |a, b| a | b),
        ("^", |a, b| a ^ b, |a, b| a ^ b),
        ("!", |a, _| !a, |a, _| !a),
        ("/", Whole::quotient, |a, b| if b == 0 { 0 } else { a.wrapping_div(b) }),
        ("%", Whole::remainder, |a, b| if b == 0 { 0 } else { a.wrapping_rem(b) }),
        ("u/", Whole::unsigned_quotient, |a, b| {
            (a as u64).checked_div(b as u64).unwrap_or(0) as i64
        }),
        ("u%", Whole::unsigned_remainder, |a, b| {
            (a as u64).checked_rem(b as u64).unwrap_or(0) as i64
        }),
        ("<<", Whole::shift_left, |a, b| (a as u64).unbounded_shl(clipped(b)) as i64),
        (">>", Whole::shift_right, |a, b| (a as u64).unbounded_shr(clipped(b)) as i64),
        ("s>>", Whole::signed_shift_right, |a, b| a.unbounded_shr(clipped(b))),
        ("min", Whole::min, i64::min),
        ("max", Whole::max, i64::max),
        ("umin", Whole::unsigned_min, |a, b| (a as u64).min(b as u64) as i64),
        ("umax", Whole::unsigned_max, |a, b| (a as u64).max(b as u64) as i64),
        ("magnitude", |a, _| a.magnitude(), |a, _| a.wrapping_abs()),
        ("u8", |a, _| a.wrapped(8, false), |a, _| i64::from(a as u8)),
        ("i16", |a, _| a.wrapped(16, true), |a, _| i64::from(a as i16)),
    ];
    pairs(&WHOLES, |a, b| {
        for (name, lanes, one) in operations {
            let wanted: [i64; LANES] = std::array::from_fn(|it| one(a[it], b[it]));
            let found = lanes(Whole::new(a), Whole::new(b)).to_array();
            assert_eq!(found, wanted, "{name} of {a:?} and {b:?}");
        }
        // 32 bits, in which a quotient of doubles is exact.
        let narrow = |values: [i64; LANES]| values.map(|value| i64::from(value as u32));
        let (a, b) = (narrow(a), narrow(b));
        let quotients = Whole::new(a).narrow_quotient(Whole::new(b)).to_array();
        let rests = Whole::new(a).narrow_remainder(Whole::new(b)).to_array();
        for lane in (0..LANES).filter(|lane| b[*lane] != 0) {
            assert_eq!([quotients[lane], rests[lane]], [a[lane] / b[lane], a[lane] % b[lane]]);
        }
    });
}

/// Returns a number of bits to shift by; more than there are for a number without a meaning.
fn clipped(by: i64) -> u32 {
    u32::try_from(by).unwrap_or(u32::MAX)
}

#[test]
fn an_element_of_each_lane_is_read_and_written_for_that_lane() {
    let mut all: [Real; 3] = [1.0, 2.0, 3.0].map(Real::of);
    let index = Whole::new([0, 1, 2, 1, 0, 99, -1, 2]);
    let picked = pick(&all, index, |it| it).to_array();
    assert_eq!(picked, [1.0, 2.0, 3.0, 2.0, 1.0, 3.0, 3.0, 3.0]);
    let mask = Mask::new([true, true, false, true, true, true, true, false]);
    each(&mut all, index, mask, |it, m| it.assign(m, &Real::of(9.0)));
    assert_eq!(all[0].to_array(), [9.0, 1.0, 1.0, 1.0, 9.0, 1.0, 1.0, 1.0]);
    assert_eq!(all[1].to_array(), [2.0, 9.0, 2.0, 9.0, 2.0, 2.0, 2.0, 2.0]);
    assert_eq!(all[2].to_array(), [3.0; LANES]);
    assert_eq!(pick(&[] as &[Real], index, |it| it).to_array(), [0.0; LANES]);
}

#[test]
fn words_of_a_lane_come_back() {
    let mut value = <[Real; 2]>::of_words(&[1.5_f64.to_bits(), 2.5_f64.to_bits()]);
    value.put(3, &mut [7.0_f64.to_bits()].into_iter());
    let words = |lane: usize| {
        let mut words = Vec::new();
        value.words(lane, &mut words);
        words.iter().map(|word| f64::from_bits(*word)).collect::<Vec<_>>()
    };
    assert_eq!(words(2), [1.5, 2.5]);
    assert_eq!(words(3), [7.0, 0.0]);
}

#[test]
fn sines_are_near_those_of_the_standard_library() {
    let mut angle = -1000.0_f64;
    while angle < 1000.0 {
        let (sine, cosine) = sin_cos(angle);
        let error = (sine - angle.sin()).abs().max((cosine - angle.cos()).abs());
        assert!(error <= 2.0_f64.powi(-51), "{error} at {angle}");
        let (sines, cosines) = sin_cos(Real::of(angle));
        assert_eq!(
            [sines.lane(5).to_bits(), cosines.lane(6).to_bits()],
            [sine.to_bits(), cosine.to_bits()]
        );
        angle += 0.013_7;
    }
}
