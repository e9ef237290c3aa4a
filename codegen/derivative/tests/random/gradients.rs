//! Gradients of random functions equal dense dual numbers, within a bound: the order of their sums differs.

use bessemer_derivative::{Kind, Request, body, derivative};
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::text::parse;

use crate::{dual, find, programs};

/// Largest difference, relative to the square of the largest number on the way.
const BOUND: f64 = 1e-12;

/// Largest number on the way of a compared call.
const LARGEST: f64 = 1e9;

/// Number of random functions; with `BESSEMER_FULL` ten times as many.
const FUNCTIONS: u64 = 200;

#[test]
fn random_functions_have_the_gradients_of_dual_numbers() {
    let large = std::thread::Builder::new().stack_size(1 << 28);
    let run = large.spawn(|| {
        let (mut compared, mut refused, mut calls) = (0, 0, 0);
        let seeds = crate::seeds(FUNCTIONS);
        let many = seeds.end - seeds.start >= FUNCTIONS;
        for seed in seeds {
            match agree(seed) {
                Some((found, of)) => {
                    compared += found;
                    calls += of;
                }
                None => refused += 1,
            }
        }
        println!("{compared} of {calls} calls compared, {refused} functions refused");
        assert!(!many || 2 * compared > calls, "only {compared} of {calls} calls were finite");
        assert!(!many || calls > 2 * FUNCTIONS as u32 / 3, "only {calls} calls");
    });
    run.expect("a thread starts").join().expect("all agree");
}

/// Compares the calls of one random function; returns the numbers of those compared and of all. None for a vector, and for a
/// loop whose length is unknown.
fn agree(seed: u64) -> Option<(u32, u32)> {
    let text = programs::program(seed);
    let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    if !text.contains("fn gradient") {
        return None;
    }
    let (of, into) = (find(&module, "subject"), find(&module, "gradient"));
    let request = Request { of, by: vec![0, 1], kind: Kind::Gradients, into };
    let (with, function) = match derivative(&module, &request) {
        Ok((mut with, function)) => {
            with.functions[into.index()] = function.clone();
            (with, function)
        }
        Err(problem)
            if ["statements", "not constant"].iter().any(|it| problem.message.contains(it)) =>
        {
            return None;
        }
        Err(problem) => panic!("{seed}: {}\n{text}", problem.message),
    };
    let shown = || format!("{text}\n{}", body(&with, &function));
    let calls = programs::calls(seed);
    let mut interpreter = Interpreter::new(&with);
    let mut compared = 0;
    for arguments in &calls {
        let expected = dual::call(&module, of, arguments);
        let found = interpreter.call(into, &mut arguments.clone());
        let plain = Interpreter::new(&module).call(of, &mut arguments.clone());
        let ((expected, largest), found, plain) = match (expected, found, plain) {
            (Some(expected), Ok(found), Ok(plain)) => (expected, found, plain),
            (_, Err(Stop::Fault { .. }), Err(Stop::Fault { .. })) => continue,
            (None, Ok(_), Ok(_)) => continue,
            (_, found, plain) => panic!("{seed}: {found:?}, {plain:?}\n{}", shown()),
        };
        assert_eq!(found[0], plain[0], "value of {seed}\n{}", shown());
        // Sums of larger numbers in another order have no digit in common.
        if largest > LARGEST {
            continue;
        }
        compared += 1;
        for (variable, word) in found[1..].iter().enumerate() {
            let (found, wanted) = (f64::from_bits(*word), expected[0].tangents[variable]);
            let error = (found - wanted).abs();
            // Bars of a long loop may be so large that the last bits of the arguments decide.
            let mut nearby = || {
                let mut moved = arguments.clone();
                moved.iter_mut().take(2).flatten().for_each(|it| *it = it.wrapping_add(1));
                let moved = interpreter.call(into, &mut moved).ok()?;
                Some((f64::from_bits(moved[1 + variable]) - found).abs())
            };
            assert!(
                error <= BOUND * largest * largest || nearby().is_none_or(|it| it >= 0.01 * error),
                "{seed} {arguments:?}: by variable {variable}: {found:e}, not {wanted:e}\n{}",
                shown()
            );
        }
    }
    Some((compared, calls.len() as u32))
}

/// The Jacobian of a gradient is the Hessian: a derivative may call what the generator wrote.
#[test]
fn the_derivative_of_a_gradient_is_the_hessian() {
    let vector = "matrix<f64, 2, 1>";
    let text = format!(
        "module demo\n\
         struct Slopes in demo {{ first: f64, second: {vector} }}\n\
         struct Pair in demo {{ first: Slopes, second: matrix<f64, 3, 2> }}\n\
         fn subject in demo(x: &{vector}) -> f64 as result {{\n\
         let a: f64 = x[0, 0] * x[0, 0];\n\
         if x[1, 0] > 0.0 {{ return a * x[1, 0]; }}\n\
         return a * a;\n}}\n\
         fn gradient in demo(x: &{vector}) -> Slopes as result {{\n}}\n\
         fn jacobian in demo(x: &{vector}) -> Pair as result {{\n}}\n"
    );
    let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    let [of, gradient, jacobian] = ["subject", "gradient", "jacobian"].map(|it| find(&module, it));
    let request = Request { of, by: vec![0], kind: Kind::Gradients, into: gradient };
    let (mut with, function) = derivative(&module, &request).expect("it has a gradient");
    with.functions[gradient.index()] = function;
    let request = Request { of: gradient, by: vec![0], kind: Kind::Jacobians, into: jacobian };
    let (mut with, function) = derivative(&with, &request).expect("it has a derivative");
    with.functions[jacobian.index()] = function;
    for ([x, y], expected) in [
        ([3.0, 2.0], [18.0, 12.0, 9.0, 12.0, 4.0, 6.0, 9.0, 6.0, 0.0]),
        ([3.0, -2.0], [81.0, 108.0, 0.0, 108.0, 108.0, 0.0, 0.0, 0.0, 0.0]),
    ] {
        let mut arguments = vec![[x, y].map(f64::to_bits).to_vec()];
        let found = Interpreter::new(&with).call(jacobian, &mut arguments).expect("it runs");
        let found: Vec<f64> = found.into_iter().map(f64::from_bits).collect();
        assert_eq!(found, expected, "{x} {y}");
    }
}

/// Extremes of matrices give their bars to the chosen elements, also in a loop that stays and at indices that are unknown.
#[test]
fn extremes_choose_an_element() {
    let vector = "matrix<f64, 3, 1>";
    let dot = "let b: f64 = a[0, 0] * 2.0 + a[1, 0] * 3.0 + a[2, 0] * 5.0;\nreturn b * b;";
    let long = |routine: &str| {
        format!(
            "let v: {vector} = x;\nlet sum: f64 = 0.0;\nfor i: usize in 0..40 {{\n\
             v[i % 3, 0] = v[i % 3, 0] * 0.75;\nsum = sum + v.{routine}() * v.{routine}();\n}}\nreturn sum;"
        )
    };
    let bodies = [
        "return x.amax() * x[0, 0];".to_owned(),
        "return x.amin() * x[0, 0];".to_owned(),
        format!("let a: {vector} = x.inf(matrix<3, 1>(x[1, 0], x[2, 0], 0.25));\n{dot}"),
        format!("let a: {vector} = x.sup(matrix<3, 1>(x[1, 0], x[2, 0], 0.25));\n{dot}"),
        long("amax"),
        long("amin"),
    ];
    for body in bodies {
        let text = format!(
            "module demo\n\
             struct Slopes in demo {{ first: f64, second: {vector} }}\n\
             struct Pair in demo {{ first: f64, second: matrix<f64, 1, 3> }}\n\
             fn subject in demo(x: &{vector}) -> f64 as result {{\n{body}\n}}\n\
             fn gradient in demo(x: &{vector}) -> Slopes as result {{\n}}\n\
             fn jacobian in demo(x: &{vector}) -> Pair as result {{\n}}\n"
        );
        let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let of = find(&module, "subject");
        let by = |name: &str, kind| {
            let into = find(&module, name);
            let request = Request { of, by: vec![0], kind, into };
            let (mut with, function) = derivative(&module, &request)
                .unwrap_or_else(|problem| panic!("{body}: {}", problem.message));
            with.functions[into.index()] = function;
            (with, into)
        };
        let (forwards, jacobian) = by("jacobian", Kind::Jacobians);
        let (backwards, gradient) = by("gradient", Kind::Gradients);
        for x in [[0.5, -2.0, 1.0], [3.0, 1.0, -1.0], [-1.0, 1.0, 0.0], [0.0, 0.0, 0.0]] {
            let arguments = vec![x.map(f64::to_bits).to_vec()];
            let call = |module, function| {
                let found = Interpreter::new(module).call(function, &mut arguments.clone());
                found.expect("it runs").into_iter().map(f64::from_bits).collect::<Vec<_>>()
            };
            let (wanted, found) = (call(&forwards, jacobian), call(&backwards, gradient));
            assert_eq!(found[0], wanted[0], "{body} {x:?}");
            for (found, wanted) in found.iter().zip(&wanted) {
                let scale = 1.0 + wanted.abs();
                assert!((found - wanted).abs() < BOUND * scale, "{body} {x:?}: {found} {wanted}");
            }
        }
    }
}

/// A loop of unknown length keeps its values in arrays of a bound. It is a limit of its range, or the length of an array from which each pass reads
/// an element. Beyond that length the gradient panics where the function does.
#[test]
fn a_loop_keeps_its_values_within_a_bound() {
    let vector = "matrix<f64, 40, 1>";
    let grown = "a = a * x[0, 0] + a.sqrt();";
    let bodies = [
        format!("for i: usize in 0..n.min(50) {{ {grown} }}"),
        format!("for i: u8 in 0..(n as u8) {{ {grown} }}"),
        format!("for i: usize in n % 7..=n % 45 {{ {grown} }}"),
        "for i: usize in 0..n { a = a * x[i, 0] + a.sqrt(); }".to_owned(),
        "for i: usize in rev 0..n { a = a * x[i, 0]; if a > 4.0 { break; } a = a * a.sqrt() + 0.75; }".to_owned(),
        "let m: usize = n.min(50) + 1;\nfor i: usize in 0..m { let k: usize = i.min(39);\na = a * x[k, 0] + a.sqrt(); }".to_owned(),
    ];
    for body in bodies {
        let text = format!(
            "module demo\nfile \"demo.rs\"\n\
             struct Slopes in demo {{ first: f64, second: {vector} }}\n\
             struct Pair in demo {{ first: f64, second: matrix<f64, 1, 40> }}\n\
             fn subject in demo(x: &{vector}, n: usize) -> f64 as result {{\nlet a: f64 = 0.5;\n{body}\nreturn a;\n}}\n\
             fn gradient in demo(x: &{vector}, n: usize) -> Slopes as result {{\n}}\n\
             fn jacobian in demo(x: &{vector}, n: usize) -> Pair as result {{\n}}\n"
        );
        let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let of = find(&module, "subject");
        let by = |name: &str, kind| {
            let into = find(&module, name);
            let request = Request { of, by: vec![0], kind, into };
            let (mut with, function) = derivative(&module, &request)
                .unwrap_or_else(|problem| panic!("{body}: {}", problem.message));
            with.functions[into.index()] = function;
            (with, into)
        };
        let (forwards, jacobian) = by("jacobian", Kind::Jacobians);
        let (backwards, gradient) = by("gradient", Kind::Gradients);
        let x: Vec<u64> = (0..40).map(|k| (1.05 - 0.005 * f64::from(k)).to_bits()).collect();
        for n in [0_u64, 1, 2, 39, 40, 41, 63, 90] {
            let arguments = vec![x.clone(), vec![n]];
            let call = |module, function| {
                let found = Interpreter::new(module).call(function, &mut arguments.clone());
                found.map(|words| words.into_iter().map(f64::from_bits).collect::<Vec<_>>())
            };
            match (call(&forwards, jacobian), call(&backwards, gradient)) {
                (Ok(wanted), Ok(found)) => {
                    assert_eq!(found[0].to_bits(), wanted[0].to_bits(), "{body} {n}");
                    for (found, wanted) in found.iter().zip(&wanted) {
                        let scale = 1.0 + wanted.abs();
                        assert!(
                            (found - wanted).abs() < BOUND * scale,
                            "{body} {n}: {found} {wanted}"
                        );
                    }
                }
                (Err(wanted), Err(found)) => {
                    let fault =
                        |it| format!("{it:?}").split(", function").next().map(str::to_owned);
                    assert_eq!(fault(found), fault(wanted), "{body} {n}");
                }
                (wanted, found) => panic!("{body} {n}: {found:?}, not {wanted:?}"),
            }
        }
    }
}

/// Each reason why a function has no gradient is reported, and so is a signature that does not fit.
#[test]
fn functions_without_a_gradient_are_refused() {
    let long = "let a: f64 = x;\nfor i: usize in 0..n { a = a * x; }\nreturn a;";
    let beyond = long.replace("0..n", "0..n.min(1025)");
    let cases = [
        ("f64", "f64", "return x.to_bits() as f64;", "the bits of a differentiated number"),
        ("f64", "f64", long, "whose length is not constant"),
        ("f64", "f64", &beyond, "no bound of at most 1024"),
        (
            "f64",
            "matrix<f64, 1, 1>",
            "return x;",
            "another result than the value and the gradients",
        ),
        ("matrix<f64, 2, 1>", "f64", "return matrix<2, 1>(x, x);", "is no number"),
    ];
    for (result, declared, body, expected) in cases {
        let text = format!(
            "module demo\nfile \"demo.rs\"\n\
             struct Pair in demo {{ first: {result}, second: {declared} }}\n\
             fn subject in demo(x: f64, n: usize) -> {result} as result {{\n{body}\n}}\n\
             fn gradient in demo(x: f64, n: usize) -> Pair as result {{\n}}\n"
        );
        let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let (of, into) = (find(&module, "subject"), find(&module, "gradient"));
        let request = Request { of, by: vec![0], kind: Kind::Gradients, into };
        let problem = derivative(&module, &request).expect_err(body);
        assert!(problem.message.contains(expected), "{body}: {}", problem.message);
    }
}
