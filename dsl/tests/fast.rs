//! The fast functions lose no more than they state. A run takes one angle in 4,093; `BESSEMER_FULL` takes each of their domain,
//! which is for an optimised build, and `UPDATE_DOCS` writes the results to `bench/results/fast.json`:
//! `BESSEMER_FULL=1 UPDATE_DOCS=1 cargo test --profile fast -p bessemer --test fast`.

use std::path::Path;

use bessemer::fast;
use bessemer::math::ElementaryMethods;
use serde_json::{Value, json};

/// Name, function, and the function of `f64` that is the truth.
type Held = (&'static str, fn(f32) -> f32, fn(f64) -> f64);

const FUNCTIONS: [Held; 2] = [("sin", fast::sin, f64::dsl_sin), ("cos", fast::cos, f64::dsl_cos)];
/// Angles up to which an error is stated, rad, with that error.
const DOMAINS: [(f32, f64); 2] = [(100.0, 7.5e-8), (10_000.0, 5e-4)];

/// Largest error of a function at the floats from `from` up to `to` of either sign, with its place and their number.
fn worst((_, function, truth): Held, from: f32, to: f32, stride: u32) -> (f64, f32, u64) {
    let (mut most, mut at, mut count) = (0.0, 0.0, 0);
    for bits in (from.to_bits()..=to.to_bits()).step_by(stride as usize) {
        for x in [f32::from_bits(bits), -f32::from_bits(bits)] {
            let error = (f64::from(function(x)) - truth(f64::from(x))).abs();
            if error > most {
                (most, at) = (error, x);
            }
            count += 1;
        }
    }
    (most, at, count)
}

#[test]
fn no_angle_loses_more_than_is_stated() {
    let full = std::env::var_os("BESSEMER_FULL").is_some();
    let mut rows: Vec<Value> = Vec::new();
    for held in FUNCTIONS {
        let mut from = 0.0_f32;
        let mut row = json!({ "function": held.0 });
        for (to, stated) in DOMAINS {
            let (most, at, inputs) = worst(held, from, to, if full { 1 } else { 4093 });
            println!("{} to {to}: {most:e} at {at:e}", held.0);
            assert!(most <= stated, "{}({at:e}) is {most:e} off", held.0);
            let error = (most * 1e10).ceil() / 1e10;
            row[format!("to {to}")] =
                json!({ "inputs": inputs, "error": error, "at": format!("{at:e}") });
            from = to;
        }
        rows.push(row);
    }
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
fn both_at_once_are_each_alone_on_every_kind_of_number() {
    let same = |a: f32, b: f32| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    for bits in (0..=u32::MAX).step_by(65_521) {
        let x = f32::from_bits(bits);
        let (sine, cosine) = fast::sin_cos(x);
        assert!(same(sine, fast::sin(x)) && same(cosine, fast::cos(x)), "{x:e}");
        assert!(x.is_finite() || sine.is_nan() && cosine.is_nan(), "{x:e}");
    }
}
