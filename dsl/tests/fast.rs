//! The fast functions lose no more than they state. A run takes one angle in 4,093; `BESSEMER_FULL` takes each of their domain,
//! which is for an optimised build, and `UPDATE_DOCS` writes the results to `bench/results/fast.json`:
//! `BESSEMER_FULL=1 UPDATE_DOCS=1 cargo test --profile fast -p bessemer --test fast`.

use std::path::Path;

use bessemer::fast;
use bessemer::math::ElementaryMethods;
use serde_json::{Value, json};

/// A function of one argument.
struct Held {
    name: &'static str,
    function: fn(f32) -> f32,
    /// The function of `f64` that is the truth.
    truth: fn(f64) -> f64,
    /// True if the error is stated relative to the result.
    is_relative: bool,
    /// Sizes of the argument up to which an error is stated, with that error.
    domains: [(f32, f64); 2],
}

/// Angles up to which an error is stated, rad, with that error.
const ANGLES: [(f32, f64); 2] = [(100.0, 7.5e-8), (10_000.0, 5e-4)];

const FUNCTIONS: [Held; 3] = [
    Held {
        name: "sin",
        function: fast::sin,
        truth: f64::dsl_sin,
        is_relative: false,
        domains: ANGLES,
    },
    Held {
        name: "cos",
        function: fast::cos,
        truth: f64::dsl_cos,
        is_relative: false,
        domains: ANGLES,
    },
    Held {
        name: "exp",
        function: fast::exp,
        truth: f64::dsl_exp,
        is_relative: true,
        domains: [(10.0, 6e-7), (87.0, 4.5e-6)],
    },
];

/// Error that `atan2` states, rad.
const ARCTANGENT_ERROR: f64 = 6e-7;

/// Largest error of a function at the floats from `from` up to `to` of either sign, with its place and their number.
fn worst(held: &Held, from: f32, to: f32, stride: u32) -> (f64, f32, u64) {
    let (mut most, mut at, mut count) = (0.0, 0.0, 0);
    for bits in (from.to_bits()..=to.to_bits()).step_by(stride as usize) {
        for x in [f32::from_bits(bits), -f32::from_bits(bits)] {
            let truth = (held.truth)(f64::from(x));
            let scale = if held.is_relative { truth.abs() } else { 1.0 };
            let error = (f64::from((held.function)(x)) - truth).abs() / scale;
            if error > most {
                (most, at) = (error, x);
            }
            count += 1;
        }
    }
    (most, at, count)
}

/// Largest error of `atan2` at pairs of numbers, half of them of any size, half of like sizes.
fn worst_angle(pairs: u64) -> (f64, [f32; 2]) {
    let (mut most, mut at, mut word) = (0.0, [0.0; 2], 1_u64);
    for index in 0..pairs {
        word = word.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let (upper, lower) = ((word >> 32) as u32, (word >> 16) as u32);
        let y = f32::from_bits(upper);
        let x = match index % 2 {
            0 => f32::from_bits(lower.wrapping_mul(2_654_435_761)),
            _ => y * ((lower >> 8) as f32 / 838_860.8 - 10.0),
        };
        let larger = x.abs().max(y.abs());
        if (1e-30..1e38).contains(&larger) && !x.is_nan() && !y.is_nan() {
            let truth = f64::from(y).dsl_atan2(f64::from(x));
            let error = (f64::from(fast::atan2(y, x)) - truth).abs();
            if error > most {
                (most, at) = (error, [y, x]);
            }
        }
    }
    (most, at)
}

#[test]
fn no_argument_loses_more_than_is_stated() {
    let full = std::env::var_os("BESSEMER_FULL").is_some();
    let mut rows: Vec<Value> = Vec::new();
    for held in &FUNCTIONS {
        let mut from = 0.0_f32;
        let mut row = json!({ "function": held.name });
        for (to, stated) in held.domains {
            let (most, at, inputs) = worst(held, from, to, if full { 1 } else { 4093 });
            println!("{} to {to}: {most:e} at {at:e}", held.name);
            assert!(most <= stated, "{}({at:e}) is {most:e} off", held.name);
            let error = (most * 1e10).ceil() / 1e10;
            row[format!("to {to}")] =
                json!({ "inputs": inputs, "error": error, "at": format!("{at:e}") });
            from = to;
        }
        rows.push(row);
    }
    let pairs = if full { 1 << 30 } else { 1 << 19 };
    let (most, at) = worst_angle(pairs);
    println!("atan2: {most:e} at {at:?}");
    assert!(most <= ARCTANGENT_ERROR, "atan2 of {at:?} is {most:e} off");
    let error = (most * 1e10).ceil() / 1e10;
    let at = format!("{:e}, {:e}", at[0], at[1]);
    rows.push(json!({ "function": "atan2", "any": { "inputs": pairs, "error": error, "at": at } }));
    if full && std::env::var_os("UPDATE_DOCS").is_some() {
        let all = json!({
            "command": "BESSEMER_FULL=1 UPDATE_DOCS=1 cargo test --profile fast -p bessemer --test fast",
            "reference": "the functions of f64",
            "functions": rows,
        });
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bench/results/fast.json");
        let text = serde_json::to_string_pretty(&all).expect("values") + "\n";
        std::fs::write(&file, text).unwrap_or_else(|why| panic!("{}: {why}", file.display()));
    }
}

#[test]
fn angles_and_powers_at_special_values() {
    use core::f32::consts::{FRAC_PI_2, PI};
    for (y, x, angle) in [
        (0.0, 0.0, 0.0),
        (0.0, -0.0, 0.0),
        (0.0, 1.0, 0.0),
        (0.0, -1.0, PI),
        (-0.0, -1.0, PI),
        (1.0, 0.0, FRAC_PI_2),
        (-1.0, 0.0, -FRAC_PI_2),
        (f32::INFINITY, 1.0, FRAC_PI_2),
        (1.0, f32::NEG_INFINITY, PI),
    ] {
        assert_eq!(fast::atan2(y, x), angle, "{y} {x}");
    }
    assert!(fast::atan2(f32::NAN, 1.0).is_nan() && fast::atan2(1.0, f32::NAN).is_nan());
    assert_eq!((fast::exp(0.0), fast::exp(-0.0)), (1.0, 1.0));
    assert!([f32::NAN, f32::INFINITY, f32::NEG_INFINITY].iter().all(|x| fast::exp(*x).is_nan()));
}

#[test]
fn both_at_once_are_each_alone_on_every_kind_of_number() {
    let same = |a: f32, b: f32| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    for bits in (0..=u32::MAX).step_by(65_521) {
        let x = f32::from_bits(bits);
        let (sine, cosine) = fast::sin_cos(x);
        assert!(same(sine, fast::sin(x)) && same(cosine, fast::cos(x)), "{x:e}");
        assert!(x.is_finite() || sine.is_nan() && cosine.is_nan(), "{x:e}");
    }
}
