//! The elementary functions: special values as C99 Annex F has them, and how far they are from the
//! platform's, which is taken to be within one unit in the last place itself.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use bessemer::math::arctangent::atan2;
use bessemer::math::sine::{cos, sin};
use bessemer::math::single::{atan2f, cosf, sinf, tanf};
use bessemer::math::tangent::tan;
use bessemer::math::{FloatMethods, OrderMethods};
use proptest::prelude::*;

const INF: f64 = f64::INFINITY;
const POINTS: u64 = 200_000;

fn is(value: f64, expected: f64) {
    let same = value.to_bits() == expected.to_bits() || value.is_nan() && expected.is_nan();
    assert!(same, "{value:?} is not {expected:?}");
}

#[test]
fn sine_cosine_and_tangent_at_special_values() {
    for odd in [sin, tan] {
        is(odd(0.0), 0.0);
        is(odd(-0.0), -0.0);
        // The smallest numbers are their own sine.
        is(odd(f64::from_bits(1)), f64::from_bits(1));
        is(odd(-f64::MIN_POSITIVE), -f64::MIN_POSITIVE);
    }
    is(cos(0.0), 1.0);
    is(cos(-0.0), 1.0);
    for undefined in [INF, -INF, f64::NAN, -f64::NAN] {
        for function in [sin, cos, tan] {
            is(function(undefined), f64::NAN);
        }
        let undefined = undefined as f32;
        for function in [sinf, cosf, tanf] {
            assert!(function(undefined).is_nan());
        }
    }
    assert_eq!(sinf(-0.0).to_bits(), (-0.0_f32).to_bits());
    assert_eq!(tanf(-0.0).to_bits(), (-0.0_f32).to_bits());
}

#[test]
fn atan2_at_special_values() {
    for sign in [1.0, -1.0] {
        is(atan2(sign * 0.0, -0.0), sign * PI);
        is(atan2(sign * 0.0, 0.0), sign * 0.0);
        for x in [f64::from_bits(1), 1.0, f64::MAX, INF] {
            is(atan2(sign * 0.0, -x), sign * PI);
            is(atan2(sign * 0.0, x), sign * 0.0);
            is(atan2(sign * x, 0.0), sign * FRAC_PI_2);
            is(atan2(sign * x, -0.0), sign * FRAC_PI_2);
        }
        for finite in [f64::from_bits(1), 1.0, f64::MAX] {
            is(atan2(sign * finite, -INF), sign * PI);
            is(atan2(sign * finite, INF), sign * 0.0);
            is(atan2(sign * INF, finite), sign * FRAC_PI_2);
            is(atan2(sign * INF, -finite), sign * FRAC_PI_2);
        }
        is(atan2(sign * INF, -INF), sign * 3.0 * FRAC_PI_4);
        is(atan2(sign * INF, INF), sign * FRAC_PI_4);
    }
    for other in [0.0, 1.0, INF, f64::NAN] {
        is(atan2(f64::NAN, other), f64::NAN);
        is(atan2(other, f64::NAN), f64::NAN);
    }
    assert_eq!(atan2f(-0.0, -1.0), -std::f32::consts::PI);
}

#[test]
fn exact_functions_at_special_values() {
    is((-0.0_f64).dsl_sqrt(), -0.0);
    is((-1.0_f64).dsl_sqrt(), f64::NAN);
    is(INF.dsl_sqrt(), INF);
    is((-0.0_f64).dsl_floor(), -0.0);
    is((-0.5_f64).dsl_floor(), -1.0);
    is(0.5_f64.dsl_floor(), 0.0);
    is((-INF).dsl_floor(), -INF);
    is((-0.0_f64).dsl_abs(), 0.0);
    is(f64::NAN.dsl_clamp(0.0, 1.0), f64::NAN);
    is((-0.0_f64).dsl_clamp(0.0, 1.0), -0.0);
    is(f64::NAN.dsl_min(f64::NAN), f64::NAN);
}

/// Numbers that are spread evenly from 0 to 1, the same in every run.
fn spread(index: u64, stride: u64) -> f64 {
    let bits = (index + 1).wrapping_mul(stride) ^ stride.rotate_left(17);
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

/// Arguments from `-limit` to `limit`, as many of each order of magnitude as evenly spread ones.
fn arguments(limit: f64) -> impl Iterator<Item = f64> {
    const STRIDE: u64 = 0x9e37_79b9_7f4a_7c15;
    (0..POINTS).map(move |index| {
        let share = spread(index, STRIDE);
        let even = (2.0 * share - 1.0) * limit;
        let graded = limit * (-40.0 * share).exp2();
        if index % 2 == 0 { even } else { graded }
    })
}

/// How many doubles lie between two.
fn ulps(a: f64, b: f64) -> u64 {
    let ordered = |x: f64| {
        let bits = x.to_bits() as i64;
        if bits < 0 { i64::MIN - bits } else { bits }
    };
    ordered(a).abs_diff(ordered(b))
}

fn ulps_f32(a: f32, b: f32) -> u64 {
    let ordered = |x: f32| {
        let bits = x.to_bits() as i32;
        i64::from(if bits < 0 { i32::MIN - bits } else { bits })
    };
    ordered(a).abs_diff(ordered(b))
}

/// The worst distance from the platform's function, and where; `--nocapture` shows it.
fn worst<X: Copy + std::fmt::Debug>(
    name: &str,
    arguments: impl Iterator<Item = X>,
    distance: impl Fn(X) -> u64,
) -> u64 {
    let (worst, x) =
        arguments.map(|x| (distance(x), x)).max_by_key(|(ulps, _)| *ulps).expect("arguments");
    println!("{name}: {worst} ulp from the platform's at {x:?}");
    worst
}

#[test]
fn double_precision_is_within_a_few_units_in_the_last_place() {
    let pairs =
        || arguments(1e6).zip(arguments(1e6).skip(7)).chain(arguments(2.0).map(|y| (y, 1.0)));
    assert!(worst("sin", arguments(1e6), |x| ulps(sin(x), x.sin())) <= 2);
    assert!(worst("cos", arguments(1e6), |x| ulps(cos(x), x.cos())) <= 2);
    assert!(worst("tan", arguments(1e6), |x| ulps(tan(x), x.tan())) <= 3);
    assert!(worst("atan2", pairs(), |(y, x)| ulps(atan2(y, x), y.atan2(x))) <= 2);
}

#[test]
fn single_precision_is_within_one_unit_in_the_last_place() {
    let singles = || arguments(1e6).map(|x| x as f32);
    let pairs = || singles().zip(singles().skip(7));
    assert!(worst("sinf", singles(), |x| ulps_f32(sinf(x), x.sin())) <= 1);
    assert!(worst("cosf", singles(), |x| ulps_f32(cosf(x), x.cos())) <= 1);
    assert!(worst("tanf", singles(), |x| ulps_f32(tanf(x), x.tan())) <= 1);
    assert!(worst("atan2f", pairs(), |(y, x)| ulps_f32(atan2f(y, x), y.atan2(x))) <= 1);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the bits: a sine and a cosine from −1 to 1, an angle from −π to π, or NaN.
    #[test]
    fn results_are_bounded_everywhere(y: f64, x: f64) {
        for value in [sin(x), cos(x)] {
            prop_assert!(value.abs() <= 1.0 || x.is_nan() || x.is_infinite());
        }
        prop_assert!(atan2(y, x).abs() <= PI || x.is_nan() || y.is_nan());
    }

    /// Odd and even, to the bit.
    #[test]
    fn signs_are_symmetric(y in -1e9..1e9_f64, x in -1e9..1e9_f64) {
        prop_assert_eq!(sin(-x).to_bits(), (-sin(x)).to_bits());
        prop_assert_eq!(cos(-x).to_bits(), cos(x).to_bits());
        prop_assert_eq!(tan(-x).to_bits(), (-tan(x)).to_bits());
        prop_assert_eq!(atan2(-y, x).to_bits(), (-atan2(y, x)).to_bits());
    }
}
