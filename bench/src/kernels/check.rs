//! Checks a result before its program is measured.
//!
//! The generated code must have the bits of the model as compiled by rustc; other contenders must have a residual
//! that fits their precision.

use super::case::{Case, Element, Numbers, Routine};

/// Converts the result's words to doubles.
pub fn numbers(case: &Case, words: &[u64]) -> Vec<f64> {
    let number = |word: &u64| match case.element {
        Element::F64 => f64::from_bits(*word),
        Element::F32 => f64::from(f32::from_bits(*word as u32)),
    };
    words.iter().map(number).collect()
}

/// Returns true if two results have the same bits; any two NaN are equal.
pub fn same(case: &Case, ours: &[u64], theirs: &[u64]) -> bool {
    let pairs = numbers(case, ours).into_iter().zip(numbers(case, theirs));
    ours.len() == theirs.len()
        && pairs.into_iter().all(|(a, b)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()))
}

/// Returns the residual of a result in units of rounding. It is `|a x - b| / (n · ε · (|a| |x| + |b|))`, with norms by
/// the largest element.
pub fn residual(case: &Case, words: &[u64]) -> f64 {
    let n = case.size;
    let given = Numbers::of(case);
    let x = numbers(case, words);
    let vector = matches!(case.routine, Routine::LuSolve | Routine::CholeskySolve);
    let columns = if vector { 1 } else { n };
    if x.len() != n * columns {
        return f64::INFINITY;
    }
    let (a, x, b) = match case.routine {
        Routine::LuSolve | Routine::CholeskySolve => (given.matrix, x, given.vector),
        Routine::Inverse => {
            let identity = (0..n * n).map(|i| if i % (n + 1) == 0 { 1.0 } else { 0.0 }).collect();
            (given.matrix, x, identity)
        }
        // a · second against x.
        Routine::Product => (given.matrix, given.second, x),
    };
    let largest = |values: &[f64]| values.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
    let mut worst: f64 = 0.0;
    for column in 0..columns {
        for row in 0..n {
            let sum: f64 = (0..n).map(|k| a[row + n * k] * x[k + n * column]).sum();
            let difference = (sum - b[row + n * column]).abs();
            // A NaN is as wrong as can be.
            worst = if difference <= worst { worst } else { difference };
        }
    }
    let epsilon = match case.element {
        Element::F64 => f64::EPSILON,
        Element::F32 => f64::from(f32::EPSILON),
    };
    worst / (n as f64 * epsilon * (largest(&a) * largest(&x) + largest(&b)))
}

/// The largest residual that is accepted. The thesis' own elimination computes a ratio in a float, and so is less
/// accurate.
pub fn allowed(contender: &str, case: &Case) -> f64 {
    match (contender, case.routine) {
        ("thesis", Routine::LuSolve) => f64::from(f32::EPSILON) / f64::EPSILON,
        // No pivoting: an inverse of numbers in [0, 1] loses some digits.
        ("thesis", _) => 1e4,
        _ => 10.0,
    }
}
