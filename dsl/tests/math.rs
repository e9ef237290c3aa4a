//! The elementary functions: special values according to C99 Annex F, and errors at reference points stored by
//! `bench/accuracy`.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use bessemer::math::arctangent::{acos, asin, atan, atan2};
use bessemer::math::exponential::{exp, exp_m1, exp2};
use bessemer::math::fused::{far_mul_add, mul_add, mul_addf};
use bessemer::math::hyperbolic::{cosh, sinh, tanh};
use bessemer::math::logarithm::{ln, ln_1p, log2, log10};
use bessemer::math::power::{powf, powi};
use bessemer::math::roots::{cbrt, hypot};
use bessemer::math::sine::{cos, sin, sin_cos};
use bessemer::math::single::*;
use bessemer::math::tangent::tan;
use bessemer::math::{FloatMethods, OrderMethods, SignMethods};
use proptest::prelude::*;

const INF: f64 = f64::INFINITY;

type One<T> = fn(T) -> T;
type Two<T> = fn(T, T) -> T;
/// Arguments and results.
type Values = &'static [(f64, f64)];

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

/// The bounds that `docs/mathematics.md` promises, in ulp, at the points that the accuracy program
/// kept: the worst that it found, and others.
#[test]
fn the_bounds_hold_at_the_points_kept() {
    let one = |name: &str| -> Option<(f64, One<f64>, One<f32>)> {
        Some(match name {
            "sin" => (0.75, sin, sinf),
            "cos" => (0.75, cos, cosf),
            "tan" => (1.0, tan, tanf),
            "asin" => (1.0, asin, asinf),
            "acos" => (1.0, acos, acosf),
            "atan" => (1.0, atan, atanf),
            "exp" => (0.75, exp, expf),
            "exp2" => (1.0, exp2, exp2f),
            "exp_m1" => (1.0, exp_m1, exp_m1f),
            "ln" => (0.75, ln, lnf),
            "log2" => (1.0, log2, log2f),
            "log10" => (1.0, log10, log10f),
            "ln_1p" => (1.0, ln_1p, ln_1pf),
            "sinh" => (1.0, sinh, sinhf),
            "cosh" => (1.0, cosh, coshf),
            "tanh" => (1.0, tanh, tanhf),
            "cbrt" => (1.0, cbrt, cbrtf),
            _ => return None,
        })
    };
    let two = |name: &str| -> (f64, Two<f64>, Two<f32>) {
        match name {
            "atan2" => (1.0, atan2, atan2f),
            "powf" => (1.0, powf, powff),
            "hypot" => (1.0, hypot, hypotf),
            other => panic!("{other}"),
        }
    };
    for line in include_str!("data/reference.txt").lines() {
        let mut words = line.split(' ');
        let name = words.next().unwrap_or_default();
        let [x, y, high, left] = [(); 4].map(|()| {
            let word = words.next().and_then(|word| u64::from_str_radix(word, 16).ok());
            f64::from_bits(word.expect("four words"))
        });
        let (bound, value, single) = match one(name) {
            Some((bound, double, single)) => (bound, double(x), single(x as f32)),
            None => {
                let (bound, double, single) = two(name);
                (bound, double(x, y), single(x as f32, y as f32))
            }
        };
        if high.is_nan() {
            assert!(value.is_nan(), "{line}");
            continue;
        }
        let error = ((value - high) / ulp(high) - left).abs();
        assert!(error <= bound, "{line}: {value:e} is {error} ulp from {high:e}");
        if x as f32 as f64 == x && y as f32 as f64 == y {
            assert!((f64::from(single) - high).abs() <= 0.55 * ulp_f32(high), "{line}: {single:e}");
        }
    }
}

/// The last place of a double.
fn ulp(x: f64) -> f64 {
    let exponent = (x.to_bits() >> 52 & 0x7ff).max(1);
    // Exact: down to the smallest number.
    f64::from_bits(exponent << 52) * 2.220446049250313e-16
}

/// The last place of a float near `x`; infinite where there is no float.
fn ulp_f32(x: f64) -> f64 {
    if x.abs() > f64::from(f32::MAX) {
        return f64::INFINITY;
    }
    ulp(x).max(2.6e-54) * 536_870_912.0
}

/// Arguments and results of C99 Annex F.
#[test]
fn special_values_are_those_of_annex_f() {
    let table: &[(One<f64>, Values)] = &[
        (
            asin,
            &[
                (0.0, 0.0),
                (-0.0, -0.0),
                (1.0, FRAC_PI_2),
                (-1.0, -FRAC_PI_2),
                (1.5, f64::NAN),
                (INF, f64::NAN),
            ],
        ),
        (acos, &[(1.0, 0.0), (-1.0, PI), (0.0, FRAC_PI_2), (-1.5, f64::NAN), (-INF, f64::NAN)]),
        (atan, &[(0.0, 0.0), (-0.0, -0.0), (INF, FRAC_PI_2), (-INF, -FRAC_PI_2), (1.0, FRAC_PI_4)]),
        (exp, &[(0.0, 1.0), (-0.0, 1.0), (INF, INF), (-INF, 0.0), (709.8, INF), (-746.0, 0.0)]),
        (
            exp2,
            &[
                (0.0, 1.0),
                (3.0, 8.0),
                (-1074.0, 5e-324),
                (1023.0, 8.98846567431158e307),
                (1024.0, INF),
                (INF, INF),
                (-INF, 0.0),
                (-1076.0, 0.0),
            ],
        ),
        (exp_m1, &[(0.0, 0.0), (-0.0, -0.0), (INF, INF), (-INF, -1.0)]),
        (
            ln,
            &[
                (0.0, -INF),
                (-0.0, -INF),
                (1.0, 0.0),
                (INF, INF),
                (-1.0, f64::NAN),
                (-INF, f64::NAN),
            ],
        ),
        (
            log2,
            &[(0.0, -INF), (1.0, 0.0), (8.0, 3.0), (5e-324, -1074.0), (INF, INF), (-1.0, f64::NAN)],
        ),
        (
            log10,
            &[(0.0, -INF), (1.0, 0.0), (1e22, 22.0), (0.001, -3.0), (INF, INF), (-1.0, f64::NAN)],
        ),
        (ln_1p, &[(0.0, 0.0), (-0.0, -0.0), (-1.0, -INF), (INF, INF), (-1.5, f64::NAN)]),
        (sinh, &[(0.0, 0.0), (-0.0, -0.0), (INF, INF), (-INF, -INF), (711.0, INF)]),
        (cosh, &[(0.0, 1.0), (-0.0, 1.0), (INF, INF), (-INF, INF), (-711.0, INF)]),
        (tanh, &[(0.0, 0.0), (-0.0, -0.0), (INF, 1.0), (-INF, -1.0), (22.0, 1.0)]),
        (cbrt, &[(0.0, 0.0), (-0.0, -0.0), (INF, INF), (-INF, -INF), (27.0, 3.0), (-8.0, -2.0)]),
    ];
    for (function, values) in table {
        for (x, expected) in *values {
            is(function(*x), *expected);
        }
        is(function(f64::NAN), f64::NAN);
    }
}

#[test]
fn powers_at_special_values() {
    for y in [0.0, -0.0] {
        for x in [0.0, 1.0, -3.0, INF, f64::NAN] {
            is(powf(x, y), 1.0);
        }
    }
    for (x, y, expected) in [
        (1.0, f64::NAN, 1.0),
        (f64::NAN, 1.0, f64::NAN),
        (2.0, f64::NAN, f64::NAN),
        (0.0, -3.0, INF),
        (-0.0, -3.0, -INF),
        (-0.0, -2.0, INF),
        (-0.0, -0.5, INF),
        (0.0, -INF, INF),
        (-0.0, 3.0, -0.0),
        (-0.0, 2.0, 0.0),
        (-1.0, INF, 1.0),
        (-1.0, -INF, 1.0),
        (-8.0, 1.0 / 3.0, f64::NAN),
        (0.5, -INF, INF),
        (2.0, -INF, 0.0),
        (0.5, INF, 0.0),
        (-2.0, INF, INF),
        (-INF, -3.0, -0.0),
        (-INF, -2.0, 0.0),
        (-INF, 3.0, -INF),
        (-INF, 2.5, INF),
        (INF, -1.0, 0.0),
        (INF, 1.0, INF),
        (-2.0, 3.0, -8.0),
        (-2.0, 1e300, INF),
        (10.0, 22.0, 1e22),
        (4.0, 0.5, 2.0),
        (2.0, -1074.0, 5e-324),
    ] {
        is(powf(x, y), expected);
    }
    is(powi(-2.0, 3), -8.0);
    is(powi(2.0, -2), 0.25);
    is(powi(f64::NAN, 0), 1.0);
    is(powi(-1.0, i32::MIN), 1.0);
    is(powi(1.1, 5), 1.1 * ((1.1 * 1.1) * (1.1 * 1.1)));
}

#[test]
fn lengths_at_special_values() {
    is(hypot(INF, f64::NAN), INF);
    is(hypot(f64::NAN, -INF), INF);
    is(hypot(1.0, f64::NAN), f64::NAN);
    is(hypot(0.0, -0.0), 0.0);
    is(hypot(-3.0, 4.0), 5.0);
    is(hypot(3e300, 4e300), 5e300);
    is(hypot(f64::MAX, f64::MAX), INF);
    is(hypot(3e-320, 4e-320), 5e-320);
}

/// Any bits, so that every exponent is as likely as another.
fn any_bits() -> impl Strategy<Value = f64> {
    prop_oneof![any::<u64>().prop_map(f64::from_bits), -4.0..4.0_f64, Just(0.0), Just(-0.0)]
}

/// std's `mul_add` is the machine's or the C library's, which round once.
fn is_fused(x: f64, a: f64, b: f64) {
    let expected = x.mul_add(a, b);
    for value in [mul_add(x, a, b), far_mul_add(x, a, b)] {
        let same = value.to_bits() == expected.to_bits() || value.is_nan() && expected.is_nan();
        assert!(same, "{x:e} * {a:e} + {b:e}: {value:e} is not {expected:e}");
    }
}

/// Every pair of a product's exponent with what is added to it, over the whole range.
#[test]
fn mul_add_rounds_once_at_every_exponent() {
    let mantissas = [0, 1, 0x0008_0000_0000_0000, 0x000f_ffff_ffff_ffff, 0x0005_5555_5555_5555];
    for exponent in (0..2047u64).step_by(31) {
        for other in (0..2047u64).step_by(29) {
            for (index, mantissa) in mantissas.iter().enumerate() {
                let x = f64::from_bits(exponent << 52 | mantissa);
                let a = f64::from_bits(other << 52 | mantissas[(index + 1) % 5]);
                let product = x * a;
                for b in [product, -product, 1e-300, -5e-324, 1e300, f64::MIN_POSITIVE] {
                    for off in [0, 1, -1, 1 << 53, -(1 << 53), 54 << 52, -(54 << 52)] {
                        is_fused(x, a, f64::from_bits(b.to_bits().wrapping_add_signed(off)));
                    }
                }
            }
        }
    }
}

#[test]
fn mul_add_at_special_values() {
    let specials = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        INF,
        -INF,
        f64::NAN,
        f64::MAX,
        f64::MIN,
        5e-324,
        -5e-324,
        f64::MIN_POSITIVE,
        1e154,
        1e-154,
        1.5,
    ];
    for x in specials {
        for a in specials {
            for b in specials {
                is_fused(x, a, b);
                let (x, a, b) = (x as f32, a as f32, b as f32);
                let (value, expected) = (mul_addf(x, a, b), x.mul_add(a, b));
                let same = value.to_bits() == expected.to_bits();
                assert!(same || value.is_nan() && expected.is_nan(), "{x:e} * {a:e} + {b:e}");
            }
        }
    }
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

    #[test]
    fn mul_add_rounds_once(x in any_bits(), a in any_bits(), b in any_bits(), off in -3..4_i64) {
        is_fused(x, a, b);
        let product = -x * a;
        is_fused(x, a, f64::from_bits(product.to_bits().wrapping_add_signed(off)));
    }

    #[test]
    fn mul_add_rounds_once_in_single_precision(x: u32, a: u32, b: u32, off in -3..4_i32) {
        let [x, a, b] = [x, a, b].map(f32::from_bits);
        let near = f32::from_bits((-x * a).to_bits().wrapping_add_signed(off));
        for b in [b, near] {
            let (value, expected) = (mul_addf(x, a, b), x.mul_add(a, b));
            let same = value.to_bits() == expected.to_bits();
            prop_assert!(same || value.is_nan() && expected.is_nan(), "{x:e} {a:e} {b:e}");
        }
    }

    #[test]
    fn sine_and_cosine_together_are_those_apart(x in any_bits()) {
        let (sine, cosine) = sin_cos(x);
        is(sine, sin(x));
        is(cosine, cos(x));
        let (sine, cosine) = sin_cosf(x as f32);
        is(sine.into(), sinf(x as f32).into());
        is(cosine.into(), cosf(x as f32).into());
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
