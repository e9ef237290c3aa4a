//! Loops whose derivatives were wrong or slow once.

use bessemer_derivative::{Kind, Request, derivative};
use bessemer_interpret::Interpreter;
use bessemer_ir::text::parse;

use crate::find;

/// Number of nested loops. Two passes on trial for each loop, in each pass of the loop around it, would be over a million.
const DEPTH: usize = 14;

/// Returns nested loops with these ranges. The derivative passes from `x` to `a` through all other numbers, one in each pass.
fn nested(range: &str) -> String {
    let numbers = (0..6).map(|n| format!("let n{n}: f64 = 1.0;\n")).collect::<String>();
    let open = (0..DEPTH).map(|n| format!("for at{n}: usize in {range} {{\n")).collect::<String>();
    let moves = (1..6).map(|n| format!("n{} = n{} + 0.5 * n{n};\n", n - 1, n - 1));
    let moves = moves.collect::<String>() + "n5 = n5 + 0.25 * x;\n";
    format!("{numbers}{open}{moves}{}return n0;", "}\n".repeat(DEPTH))
}

/// A path that goes on behind a branch may leave the loop further than the sides of the branch do.
#[test]
fn what_follows_an_early_end_may_leave_further() {
    let cases = [
        ("if n < 2 { break; }\nreturn 2.0 * x;", "3.0 * x"),
        ("if n < 2 { continue; }\nreturn 2.0 * x;", "3.0 * x"),
        ("if n < 2 { continue; }\nbreak;", "y"),
        ("if n < 2 { continue; }\nif n < 4 { break; }\nreturn 2.0 * x;", "y"),
        ("if n < 2 { if i < 1 { continue; }\nbreak; }\nif i < 2 { continue; }\nreturn y;", "y"),
    ];
    for (body, behind) in cases {
        let text = format!(
            "module demo\n\
             struct Pair in demo {{ first: f64, second: f64 }}\n\
             fn subject in demo(x: f64, n: usize) -> f64 as result {{\n\
             let y: f64 = x;\nfor i: usize in 0..3 {{\ny = y * x;\n{body}\n}}\nreturn {behind};\n}}\n\
             fn slope in demo(x: f64, n: usize) -> Pair as result {{\n}}\n"
        );
        let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let (of, into) = (find(&module, "subject"), find(&module, "slope"));
        for kind in [Kind::Jacobians, Kind::Gradients] {
            let request = Request { of, by: vec![0], kind, into };
            let (mut with, function) = derivative(&module, &request)
                .unwrap_or_else(|problem| panic!("{body}: {}", problem.message));
            with.functions[into.index()] = function;
            for n in 0..5_u64 {
                let value = |x: f64| {
                    let mut arguments = vec![vec![x.to_bits()], vec![n]];
                    let found = Interpreter::new(&module).call(of, &mut arguments);
                    f64::from_bits(found.expect("it runs")[0])
                };
                let mut arguments = vec![vec![1.5_f64.to_bits()], vec![n]];
                let found = Interpreter::new(&with).call(into, &mut arguments).expect("it runs");
                let [first, slope] = [0, 1].map(|at| f64::from_bits(found[at]));
                assert_eq!(first, value(1.5), "{body} {n}");
                let difference = (value(1.5 + 1e-6) - value(1.5 - 1e-6)) / 2e-6;
                assert!((slope - difference).abs() < 1e-6, "{body} {n}: {slope} {difference}");
            }
        }
    }
}

/// A number that a long loop in a branch changes is not its first value behind the loop.
#[test]
fn a_branch_keeps_what_its_loop_changed() {
    let text = "module demo\n\
        struct Pair in demo { first: f64, second: f64 }\n\
        fn subject in demo(x: f64, n: usize) -> f64 as result {\n\
        let y: f64 = x;\n\
        if n > 0 {\n\
        let m: f64 = 0.5;\n\
        for i: usize in 0..40 { m = m * 0.5 + x; }\n\
        y = m * (x + 1.0);\n}\nreturn y;\n}\n\
        fn slope in demo(x: f64, n: usize) -> Pair as result {\n}\n";
    let module = parse(text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    let (of, into) = (find(&module, "subject"), find(&module, "slope"));
    let slope = |kind| {
        let request = Request { of, by: vec![0], kind, into };
        let (mut with, function) = derivative(&module, &request).expect("it has a derivative");
        with.functions[into.index()] = function;
        let mut arguments = vec![vec![3.0_f64.to_bits()], vec![1]];
        let found = Interpreter::new(&with).call(into, &mut arguments).expect("it runs");
        f64::from_bits(found[1])
    };
    // m is 2 x, so y is 2 x (x + 1).
    assert!((slope(Kind::Jacobians) - 14.0).abs() < 1e-9);
    assert!((slope(Kind::Gradients) - 14.0).abs() < 1e-9);
}

/// Nested loops cost the generator no more than their statements: each loop is decided once, not anew in each pass of the
/// loops around it.
#[test]
fn nested_loops_are_decided_once() {
    for (kind, range) in [(Kind::Jacobians, "0..n"), (Kind::Gradients, "0..40")] {
        let text = format!(
            "module demo\n\
             struct Pair in demo {{ first: f64, second: f64 }}\n\
             fn subject in demo(x: f64, n: usize) -> f64 as result {{\n{}\n}}\n\
             fn slope in demo(x: f64, n: usize) -> Pair as result {{\n}}\n",
            nested(range)
        );
        let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let (of, into) = (find(&module, "subject"), find(&module, "slope"));
        let request = Request { of, by: vec![0], kind, into };
        let (mut with, function) =
            derivative(&module, &request).unwrap_or_else(|problem| panic!("{}", problem.message));
        if kind == Kind::Jacobians {
            with.functions[into.index()] = function;
            let mut arguments = vec![vec![2.0_f64.to_bits()], vec![1]];
            let found = Interpreter::new(&with).call(into, &mut arguments).expect("it runs");
            let plain = Interpreter::new(&module).call(of, &mut arguments).expect("it runs");
            // In one pass `x` reaches `n5` alone, so `n0` does not depend on it yet.
            assert_eq!(found, [plain[0], 0.0_f64.to_bits()]);
        }
    }
}
