//! Callees: aliases, globs, re-exports, methods in every spelling; and the forms of statements.

#![allow(clippy::needless_borrow, clippy::wildcard_in_or_patterns, clippy::let_and_return)]

use bessemer::generate::tree::{ExprKind, Pattern, Range, Source, Stmt};
use bessemer::prelude::*;

use super::{callees, function, tail};

/// Module of the functions.
pub mod near {
    use bessemer::prelude::*;

    /// Twice.
    #[function]
    pub fn twice(x: f64) -> f64 {
        2.0 * x
    }

    /// Half.
    #[function]
    pub fn half(x: f64) -> f64 {
        x / 2.0
    }

    /// Module that re-exports them.
    pub mod again {
        pub use super::half as halved;
        pub use super::twice;
    }
}

use near::twice as doubled;

/// Functions by any other name.
#[function]
pub fn by_name(x: f64) -> f64 {
    use near::again::*;
    doubled(x)
        + twice(x)
        + near::again::halved(x)
        + self::near::half(x)
        + crate::syntax::near::twice(x)
}

/// A gain.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gain {
    /// Its value.
    pub value: f64,
}

/// Another name for it.
type Amplification = Gain;
/// Another name for a float.
type Real = f64;

#[data]
impl Gain {
    /// Returns a gain of a value.
    pub fn of(value: f64) -> Gain {
        Gain { value }
    }

    /// Scales.
    pub fn apply(&self, x: f64) -> f64 {
        self.value * x
    }

    /// Grows: the name of a function of floats.
    pub fn exp(&mut self) -> f64 {
        self.value *= 2.0;
        self.value
    }

    /// Kept between two others: the name of a method of floats.
    pub fn clamp(&self, low: &Gain, high: &Gain) -> Gain {
        Gain { value: self.value.clamp(low.value, high.value) }
    }

    /// A method that calls a free function of its own name.
    pub fn twice(&mut self) -> f64 {
        near::twice(self.exp()) + twice(self.value)
    }
}

use near::twice;

/// Methods in every spelling.
#[function]
pub fn by_method(gain: Gain, shared: &Gain, exclusive: &mut Gain) -> f64 {
    let kept = gain.clamp(shared, &Gain::of(1.0));
    let grown = Gain::exp(exclusive);
    gain.apply(1.0)
        + shared.apply(2.0)
        + exclusive.apply(3.0)
        + (&gain).apply(4.0)
        + Gain::apply(shared, 5.0)
        + Amplification::apply(&kept, grown)
        + <Gain>::apply(&gain, 6.0)
}

/// Floats in every spelling.
#[function]
pub fn by_float(x: f64, y: &f32) -> f64 {
    let s = x.sqrt() + f64::sqrt(x) + Real::sqrt(x) + <f64>::sqrt(x);
    s + y.sin() as f64 + 2.0.max(x)
}

/// Statements in every form.
#[function]
pub fn statements(n: i32, letter: u8) -> i32 {
    let mut sum = 0;
    for i in (0..n).rev() {
        sum += i;
        if sum > 100 {
            break;
        }
    }
    for _ in 0..=3 {
        sum -= 1;
    }
    match n {
        -1 => sum = 1,
        2 | 3 => return 4,
        5 | _ => (),
    }
    if letter == b'A' {
        sum += 1
    } else if letter == b'B' {
        sum += 2
    };
    assert!(sum < 1_000, "the sum is {sum}");
    {
        let kept = sum;
        kept
    }
}

#[test]
fn functions_are_found_by_any_name() {
    let path = "syntax::near";
    let [twice, half] = [format!("{path}::twice"), format!("{path}::half")];
    let expected = [&twice, &twice, &half, &half, &twice];
    assert_eq!(callees(&function("syntax::by_name")).iter().collect::<Vec<_>>(), expected);
}

#[test]
fn methods_are_found_in_any_spelling() {
    let apply = "syntax::Gain::apply";
    let expected = ["syntax::Gain::of", "syntax::Gain::clamp", "syntax::Gain::exp"];
    let callees = callees(&function("syntax::by_method"));
    let (first, rest) = callees.split_at(3);
    let mut first = first.to_vec();
    first.sort();
    let mut sorted = expected.map(str::to_owned);
    sorted.sort();
    assert_eq!(first, sorted);
    assert_eq!(rest, [apply; 7]);
}

#[test]
fn a_method_may_share_a_name_with_a_function() {
    let expected = ["syntax::Gain::exp", "syntax::near::twice", "syntax::near::twice"];
    assert_eq!(callees(&function("syntax::Gain::twice")), expected);
    let clamp = callees(&function("syntax::Gain::clamp"));
    assert_eq!(clamp, ["Scalar(Clamp)"]);
}

#[test]
fn operations_are_found_in_any_spelling() {
    let expected = ["Scalar(Sqrt)"; 4];
    let callees = callees(&function("syntax::by_float"));
    assert_eq!(callees[..4], expected);
    assert_eq!(callees[4..], ["bessemer::math::single::sinf", "Scalar(Max)"]);
}

#[test]
fn statements_keep_their_form() {
    let statements = function("syntax::statements");
    let stmts = &statements.tree.body.stmts;
    let kinds = |stmt: &Stmt| match stmt {
        Stmt::Let { .. } | Stmt::Apart { .. } => "let",
        Stmt::Expr(expr) => match expr.kind {
            ExprKind::Each { .. } => "for",
            ExprKind::Match(..) => "match",
            ExprKind::If(..) => "if",
            ExprKind::Assert(..) => "assert",
            _ => "other",
        },
    };
    let kinds: Vec<_> = stmts.iter().map(kinds).collect();
    assert_eq!(kinds, ["let", "for", "for", "match", "if", "assert"]);
    assert!(matches!(tail(&statements).kind, ExprKind::Block(_)));

    let Stmt::Expr(first) = &stmts[1] else { panic!("a loop") };
    let ExprKind::Each { source, .. } = &first.kind else { panic!("a loop") };
    let Source::Rev(of) = &**source else { panic!("its order") };
    assert!(matches!(**of, Source::Numbers(Range { inclusive: false, .. })));
}

#[test]
fn arms_keep_their_values() {
    let statements = function("syntax::statements");
    let Stmt::Expr(expr) = &statements.tree.body.stmts[3] else { panic!("a match") };
    let ExprKind::Match(_, arms) = &expr.kind else { panic!("a match") };
    let counts = arms.iter().map(|arm| match &arm.pattern {
        Pattern::Or(cases) => cases.len(),
        _ => 1,
    });
    assert_eq!(counts.collect::<Vec<_>>(), [1, 2, 2]);
}

#[test]
fn the_rust_runs_as_written() {
    assert_eq!(by_name(8.0), 16.0 + 16.0 + 4.0 + 4.0 + 16.0);
    let (gain, mut other) = (Gain::of(0.5), Gain::of(1.0));
    assert_eq!(
        by_method(gain, &Gain::of(0.25), &mut other),
        0.5 + 0.5 + 6.0 + 2.0 + 1.25 + 1.0 + 3.0
    );
    assert_eq!(other.twice(), 16.0);
    assert_eq!(by_float(4.0, &0.0), 12.0);
    assert_eq!((statements(-1, b'A'), statements(3, 0), statements(4, b'B')), (2, 4, 4));
}
