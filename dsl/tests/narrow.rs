//! The functions of `f32` in `f32` alone: special values as C99, Annex F, has them, and at most one unit in the last place
//! lost. A run takes one input in 4,093 from a start that the commit gives; `BESSEMER_FULL` takes each of them, which is
//! for an optimised build, and `UPDATE_DOCS` writes what came of that to `bench/results/single.json`:
//! Another word than 1 is the name of the only function to take.
//! `BESSEMER_FULL=1 UPDATE_DOCS=1 cargo test --profile fast -p bessemer --test narrow -- --test-threads=1`.

use std::f64::consts::PI;
use std::path::Path;

use bessemer::math::narrow::*;
use bessemer::math::{ElementaryMethods, narrow};
use serde_json::{Map, Value, json};

type One = (&'static str, fn(f32) -> f32, fn(f64) -> f64);
type Two = (&'static str, fn(f32, f32) -> f32, fn(f64, f64) -> f64);

/// The functions of one argument, and what they are held against.
const ONE: &[One] = &[
    ("sin", sinf, f64::dsl_sin),
    ("cos", cosf, f64::dsl_cos),
    ("tan", tanf, f64::dsl_tan),
    ("asin", asinf, f64::dsl_asin),
    ("acos", acosf, f64::dsl_acos),
    ("atan", atanf, f64::dsl_atan),
    ("exp", expf, f64::dsl_exp),
    ("exp2", exp2f, f64::dsl_exp2),
    ("exp_m1", exp_m1f, f64::dsl_exp_m1),
    ("ln", lnf, f64::dsl_ln),
    ("log2", log2f, f64::dsl_log2),
    ("log10", log10f, f64::dsl_log10),
    ("ln_1p", ln_1pf, f64::dsl_ln_1p),
    ("sinh", sinhf, f64::dsl_sinh),
    ("cosh", coshf, f64::dsl_cosh),
    ("tanh", tanhf, f64::dsl_tanh),
    ("cbrt", cbrtf, f64::dsl_cbrt),
];

/// The functions of two.
const TWO: &[Two] = &[
    ("atan2", atan2f, f64::dsl_atan2),
    ("powf", powff, f64::dsl_powf),
    ("hypot", hypotf, f64::dsl_hypot),
];

/// 2¹²⁸: where the floats would go on.
const BEYOND: f64 = 340_282_366_920_938_463_463_374_607_431_768_211_456.0;

/// Returns the error of a float in units of its last place.
fn error(value: f32, truth: f64) -> f64 {
    if value.is_nan() || truth.is_nan() {
        return if value.is_nan() == truth.is_nan() { 0.0 } else { f64::INFINITY };
    }
    let wide =
        if value.is_infinite() { BEYOND.copysign(f64::from(value)) } else { f64::from(value) };
    let truth = truth.clamp(-BEYOND, BEYOND);
    let exponent = (truth.to_bits() >> 52 & 0x7ff).clamp(1023 - 126, 1023 + 127);
    // Exact: 2^(exponent − 23).
    (wide - truth).abs() / f64::from_bits((exponent - 23) << 52)
}

/// Returns the stride between tested inputs, and the first input.
fn stride() -> (usize, u32) {
    let turn = std::env::var("BESSEMER_TURN").ok().and_then(|it| it.parse().ok()).unwrap_or(0u32);
    match std::env::var_os("BESSEMER_FULL") {
        Some(_) => (1, 0),
        None => (4093, turn.wrapping_mul(1009) % 4093),
    }
}

/// Keeps what a whole run found of one function, where it is asked to. A bound of `f64` is below 2⁻²⁸ units of `f32`, so the
/// functions of `f64` stand for the truth.
fn record(name: &str, inputs: u64, most: f64, at: &str) {
    if std::env::var_os("UPDATE_DOCS").is_none() || stride().0 != 1 {
        return;
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bench/results/single.json");
    let before = std::fs::read_to_string(&file).ok();
    let before = before.and_then(|text| serde_json::from_str::<Value>(&text).ok());
    let mut functions = match before.as_ref().and_then(|it| it.get("functions")) {
        Some(Value::Object(functions)) => functions.clone(),
        _ => Map::new(),
    };
    let ulp = (most * 1e4).round() / 1e4;
    functions.insert(name.to_owned(), json!({ "inputs": inputs, "ulp": ulp, "at": at }));
    let all = json!({
        "command": "BESSEMER_FULL=1 UPDATE_DOCS=1 cargo test --profile fast -p bessemer --test narrow -- --test-threads=1",
        "reference": "the functions of f64",
        "functions": functions,
    });
    let text = serde_json::to_string_pretty(&all).expect("values") + "\n";
    std::fs::write(&file, text).unwrap_or_else(|why| panic!("{}: {why}", file.display()));
}

/// Returns true if a function is tested: all are, unless one is requested by name.
fn is_asked(name: &str) -> bool {
    std::env::var("BESSEMER_FULL").map_or(true, |only| only == "1" || only == name)
}

#[test]
fn no_float_loses_more_than_a_unit_in_the_last_place() {
    let (stride, first) = stride();
    for (name, function, truth) in ONE.iter().filter(|it| is_asked(it.0)) {
        let (mut most, mut at) = (0.0, 0.0);
        for bits in (first..=u32::MAX).step_by(stride) {
            let x = f32::from_bits(bits);
            let error = error(function(x), truth(f64::from(x)));
            if error > most {
                (most, at) = (error, x);
            }
        }
        println!("{name}: {most:.4} ulp at {at:e}");
        record(name, 1 << 32, most, &format!("{at:e}"));
        assert!(most <= 1.0, "{name}({at:e}) is {most} ulp off");
    }
}

#[test]
fn no_pair_of_floats_loses_more_either() {
    let (stride, first) = stride();
    for (name, function, truth) in TWO.iter().filter(|it| is_asked(it.0)) {
        let (mut most, mut at) = (0.0, (0.0, 0.0));
        let mut word = u64::from(first) << 32;
        for index in 0..(1u64 << 30) / stride as u64 {
            word = word.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(index | 1);
            let [high, low] = [(word >> 32) as u32, word as u32 ^ (word >> 40) as u32];
            let tame = |bits: u32| (bits >> 8) as f32 / 838_860.8 - 10.0;
            let (x, y) = match index % 3 {
                0 => (f32::from_bits(high), f32::from_bits(low)),
                1 => (f32::from_bits(high), f32::from_bits(high) * tame(low)),
                _ => (tame(high), tame(low)),
            };
            let error = error(function(x, y), truth(f64::from(x), f64::from(y)));
            if error > most {
                (most, at) = (error, (x, y));
            }
        }
        println!("{name}: {most:.4} ulp at {at:?}");
        record(name, 1 << 30, most, &format!("{:e}, {:e}", at.0, at.1));
        assert!(most <= 1.0, "{name}{at:?} is {most} ulp off");
    }
}

#[test]
fn sine_and_cosine_together_are_those_apart() {
    let (stride, first) = stride();
    for bits in (first..=u32::MAX).step_by(64 * stride) {
        let x = f32::from_bits(bits);
        let (sine, cosine) = sin_cosf(x);
        let same = |a: f32, b: f32| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
        assert!(same(sine, sinf(x)) && same(cosine, cosf(x)), "{x:e}");
    }
}

/// A value as the table spells it.
fn value(word: &str) -> f32 {
    let (sign, word) = word.strip_prefix('-').map_or((1.0, word), |rest| (-1.0, rest));
    let number = match word {
        "nan" => f64::NAN,
        "inf" => f64::INFINITY,
        "pi" => PI,
        "pi/2" => PI / 2.0,
        "pi/4" => PI / 4.0,
        "3pi/4" => 3.0 * PI / 4.0,
        number => number.parse().unwrap_or_else(|_| panic!("`{number}` is no number")),
    };
    (sign * number) as f32
}

#[test]
fn special_values_are_those_of_annex_f() {
    let mut held = 0;
    for line in include_str!("data/annex_f.txt").lines().filter(|line| !line.starts_with('#')) {
        let (call, expected) = line.split_once(" -> ").expect("a result");
        let mut words = call.split(' ');
        let name = words.next().expect("a name");
        let arguments: Vec<f32> = words.map(value).collect();
        let result = match arguments[..] {
            [x] => ONE.iter().find(|(own, ..)| *own == name).map(|(_, function, _)| function(x)),
            [x, y] => TWO.iter().find(|(own, ..)| *own == name).map(|(_, of, _)| of(x, y)),
            _ => None,
        };
        let Some(result) = result else { continue };
        let expected = value(expected);
        let same = result.to_bits() == expected.to_bits() || result.is_nan() && expected.is_nan();
        assert!(same, "{line}: {result:?}");
        held += 1;
    }
    assert!(held > 150, "{held} lines are of these functions");
}

#[test]
fn powers_of_whole_numbers_are_products() {
    assert_eq!(narrow::powif(1.1, 3), 1.1 * (1.1 * 1.1));
    assert_eq!(narrow::powif(2.0, -3), 0.125);
    assert_eq!(narrow::powif(0.0, 0), 1.0);
}
