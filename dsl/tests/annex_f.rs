//! Special values: every line of `data/annex_f.txt`, in both formats, by the methods that a model calls.

use std::f64::consts::PI;

use bessemer::math::{ElementaryMethods, FloatMethods, RoundMethods, SignMethods};

/// A value as the table spells it.
fn value(word: &str) -> f64 {
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
    sign * number
}

macro_rules! called {
    ($name:expr, $arguments:expr; $($one:ident $function:ident),*; $($two:ident $of_two:ident),*) => {
        match ($name, $arguments) {
            $((stringify!($one), [x]) => x.$function(),)*
            $((stringify!($two), [x, y]) => x.$of_two(*y),)*
            ("rem", [x, y]) => x % y,
            ("mul_add", [x, a, b]) => x.dsl_mul_add(*a, *b),
            (name, _) => panic!("`{name}` is no function of so many arguments"),
        }
    };
}

macro_rules! result {
    ($name:expr, $arguments:expr) => {
        called!($name, $arguments;
            sin dsl_sin, cos dsl_cos, tan dsl_tan, asin dsl_asin, acos dsl_acos, atan dsl_atan,
            exp dsl_exp, exp2 dsl_exp2, exp_m1 dsl_exp_m1, ln dsl_ln, log2 dsl_log2, log10 dsl_log10,
            ln_1p dsl_ln_1p, sinh dsl_sinh, cosh dsl_cosh, tanh dsl_tanh, cbrt dsl_cbrt,
            sqrt dsl_sqrt, abs dsl_abs, floor dsl_floor, ceil dsl_ceil, round dsl_round,
            trunc dsl_trunc;
            atan2 dsl_atan2, powf dsl_powf, hypot dsl_hypot, copysign dsl_copysign)
    };
}

#[test]
fn every_line_of_the_table_holds() {
    let table = include_str!("data/annex_f.txt").lines().filter(|line| !line.starts_with('#'));
    for line in table {
        let (call, expected) = line.split_once(" -> ").expect("a result");
        let mut words = call.split(' ');
        let name = words.next().expect("a name");
        let arguments: Vec<f64> = words.map(value).collect();
        let single: Vec<f32> = arguments.iter().map(|&x| x as f32).collect();
        let expected = value(expected);
        let double: f64 = result!(name, arguments.as_slice());
        let single: f32 = result!(name, single.as_slice());
        let same = double.to_bits() == expected.to_bits()
            && single.to_bits() == (expected as f32).to_bits();
        let both_nan = double.is_nan() && single.is_nan() && expected.is_nan();
        assert!(same || both_nan, "{line}: {double:?}, in single precision {single:?}");
    }
}
