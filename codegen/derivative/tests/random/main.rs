//! Random functions with branches, loops, early ends and calls: the derivative equals dense dual numbers ([`dual`]).
//!
//! The interpreter runs the derivative; its value has the bits of the function.
//!
//! A derivative that is known to be zero is not computed, where dual numbers add a zero: the sign of a zero may differ, and
//! a function that meets an infinity or NaN is left out. At least half of the calls must remain.
//!
//! `BESSEMER_RANDOM=10000` differentiates ten thousand functions, from the seed `BESSEMER_RANDOM_FROM` on.

mod covariance;
mod differences;
mod dual;
mod gradients;
mod kernels;
mod loops;
mod printed;

mod programs;

use bessemer_derivative::{Kind, Request, body, derivative};
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::text::{parse, print};
use bessemer_ir::{Block, Function, FunctionId, Module};

/// Number of random functions; with `BESSEMER_FULL` ten times as many.
const FUNCTIONS: u64 = 150;

/// Returns the seeds of a run: the chosen ones, or a number of functions.
fn seeds(functions: u64) -> std::ops::Range<u64> {
    let number = |name: &str| std::env::var(name).ok()?.parse::<u64>().ok();
    let full = if std::env::var_os("BESSEMER_FULL").is_some() { 10 } else { 1 };
    let from = number("BESSEMER_RANDOM_FROM").unwrap_or(0);
    from..from + number("BESSEMER_RANDOM").unwrap_or(full * functions)
}

/// Returns the function with a name.
fn find(module: &Module, name: &str) -> FunctionId {
    let at = module.functions.iter().position(|it| it.name == name);
    FunctionId(at.unwrap_or_else(|| panic!("the module has `{name}`")) as u32)
}

/// Returns the module with the derivative in place of its declaration.
fn with_derivative(module: &Module) -> Option<(Module, Function)> {
    let (of, into) = (find(module, "subject"), find(module, "jacobian"));
    let request = Request { of, by: vec![0, 1], kind: Kind::Jacobians, into };
    match derivative(module, &request) {
        Ok((mut module, function)) => {
            module.functions[into.index()] = function.clone();
            Some((module, function))
        }
        Err(problem) if problem.message.contains("statements") => None,
        Err(problem) => panic!("{}: {}\n{}", problem.message, problem.help, print(module)),
    }
}

#[test]
fn random_functions_have_the_derivatives_of_dual_numbers() {
    let large = std::thread::Builder::new().stack_size(1 << 28);
    let run = large.spawn(|| {
        let (mut calls, mut compared, mut slopes) = (0, 0, 0);
        let seeds = seeds(FUNCTIONS);
        let many = seeds.end - seeds.start >= FUNCTIONS;
        for seed in seeds {
            let (found, of, differences) = agree(seed);
            calls += of;
            compared += found;
            slopes += differences;
        }
        println!("{compared} of {calls} calls compared, {slopes} derivatives with differences");
        assert!(!many || slopes > compared, "only {slopes} derivatives of {compared} calls");
        assert!(!many || 2 * compared > calls, "only {compared} of {calls} calls were finite");
    });
    run.expect("a thread starts").join().expect("all agree");
}

/// Compares the calls of one random function; returns the numbers of those compared, of all, and of the derivatives that
/// differences confirm.
fn agree(seed: u64) -> (u32, u32, u32) {
    let text = programs::program(seed);
    let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    let Some((derived, function)) = with_derivative(&module) else { return (0, 1, 0) };
    let shown = || format!("{text}\n{}", body(&derived, &function));
    let (of, into) = (find(&module, "subject"), find(&module, "jacobian"));
    let (mut compared, mut slopes) = (0, 0);
    let calls = programs::calls(seed);
    let mut interpreter = Interpreter::new(&derived);
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
        compared += 1;
        assert_eq!(found[..plain.len()], plain[..], "value of {seed}\n{}", shown());
        // The Jacobian by `x` and then the one by `y`, both by columns.
        let rows = plain.len();
        // The differences of larger numbers have too few digits.
        if largest <= 1e3 {
            slopes += differences(&module, of, arguments, &found[rows..], &shown);
        }
        for (index, word) in found[rows..].iter().enumerate() {
            let (row, variable) = (index % rows, index / rows);
            let (found, wanted) = (f64::from_bits(*word), expected[row].tangents[variable]);
            assert!(
                found == wanted,
                "{seed} {arguments:?}: by variable {variable} of word {row}: {found:e}, not {wanted:e}\n{}",
                shown()
            );
        }
    }
    (compared, calls.len() as u32, slopes)
}

/// Compares Jacobians with differences; returns the number of compared derivatives.
fn differences(
    module: &Module,
    of: FunctionId,
    arguments: &differences::Words,
    jacobians: &[u64],
    shown: &dyn Fn() -> String,
) -> u32 {
    let variables = arguments.iter().take(2).enumerate();
    let variables = variables.flat_map(|(at, words)| (0..words.len()).map(move |word| (at, word)));
    let mut compared = 0;
    let mut found = jacobians.iter().map(|word| f64::from_bits(*word));
    let rows = jacobians.len() / variables.clone().count();
    for variable in variables {
        let mut slopes = differences::slopes(module, of, arguments, variable);
        slopes.resize(rows, None);
        for (row, (slope, found)) in slopes.into_iter().zip(found.by_ref()).enumerate() {
            let Some(slope) = slope else { continue };
            compared += 1;
            assert!(
                differences::agree(found, slope),
                "{arguments:?}: word {row} by {variable:?}: {found:e}, and by differences {slope:e}\n{}",
                shown()
            );
        }
    }
    compared
}

/// A variable on which nothing depends has no code.
#[test]
fn zeros_and_ones_are_not_computed() {
    let text = "module demo\n\
        struct Pair in demo { first: matrix<f64, 2, 1>, second: matrix<f64, 2, 2>, third: matrix<f64, 2, 1> }\n\
        fn subject in demo(x: &matrix<f64, 2, 1>, y: f64) -> matrix<f64, 2, 1> as result {\n\
          return matrix<2, 1>(x[0, 0] + y * x[1, 0], x[1, 0]);\n\
        }\n\
        fn jacobian in demo(x: &matrix<f64, 2, 1>, y: f64) -> Pair as result {\n\
          return struct Pair { first: x, second: splat<2, 2>(0.0), third: x };\n\
        }\n";
    let module = parse(text).expect("it parses");
    let (derived, function) = with_derivative(&module).expect("it is small");
    let Block(statements) = &function.body;
    assert!(!statements.is_empty());
    let expected = "    let result_0 = x[0] + y * x[1];\n\
        \x20   let mut jacobian: SMatrix<f64, 2, 2> = SMatrix::zeros();\n\
        \x20   jacobian[(0, 0)] = 1.0;\n\
        \x20   jacobian[(0, 1)] = y;\n\
        \x20   jacobian[(1, 1)] = 1.0;\n\
        \x20   let mut jacobian_2: SVector<f64, 2> = SVector::zeros();\n\
        \x20   jacobian_2[0] = x[1];\n\
        \x20   (vector![result_0, x[1]], jacobian, jacobian_2)\n";
    assert_eq!(body(&derived, &function), expected);
}

/// Magnitudes and extremes of matrices have the derivatives of the chosen elements; a tie is the first element's.
#[test]
fn magnitudes_and_extremes_choose_an_element() {
    let at = [[0.5, -2.0], [3.0, 1.0], [-1.0, 1.0], [0.0, 0.0]];
    type Jacobian = fn([f64; 2]) -> [[f64; 2]; 2];
    let cases: [(&str, Jacobian); 5] = [
        ("x.magnitudes()", |x| [[sign(x[0]), 0.0], [0.0, sign(x[1])]]),
        ("x.inf(y * x)", |x| {
            [[chosen(x[0] <= 2.0 * x[0]), 0.0], [0.0, chosen(x[1] <= 2.0 * x[1])]]
        }),
        ("x.sup(y * x)", |x| {
            [[chosen(x[0] >= 2.0 * x[0]), 0.0], [0.0, chosen(x[1] >= 2.0 * x[1])]]
        }),
        ("matrix<2, 1>(x.amax(), y)", |x| [largest(x[0].abs() >= x[1].abs(), x), [0.0, 0.0]]),
        ("matrix<2, 1>(x.amin(), y)", |x| [largest(x[0].abs() <= x[1].abs(), x), [0.0, 0.0]]),
    ];
    for (value, expected) in cases {
        let value = value.replace("y * x", "matrix<2, 1>(y * x[0, 0], y * x[1, 0])");
        let text = format!(
            "module demo\n\
             struct Pair in demo {{ first: matrix<f64, 2, 1>, second: matrix<f64, 2, 2>, third: matrix<f64, 2, 1> }}\n\
             fn subject in demo(x: &matrix<f64, 2, 1>, y: f64) -> matrix<f64, 2, 1> as result {{\nreturn {value};\n}}\n\
             fn jacobian in demo(x: &matrix<f64, 2, 1>, y: f64) -> Pair as result {{\n\
             return struct Pair {{ first: x, second: splat<2, 2>(0.0), third: x }};\n}}\n"
        );
        let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let (derived, _) = with_derivative(&module).expect("it is small");
        for x in at {
            let words = vec![x.map(f64::to_bits).to_vec(), vec![2.0_f64.to_bits()]];
            let into = find(&module, "jacobian");
            let found = Interpreter::new(&derived).call(into, &mut words.clone()).expect("it runs");
            let plain =
                Interpreter::new(&module).call(find(&module, "subject"), &mut words.clone());
            assert_eq!(found[..2], plain.expect("it runs")[..], "{value} {x:?}");
            let found: Vec<f64> = found.into_iter().map(f64::from_bits).collect();
            let found = [[found[2], found[4]], [found[3], found[5]]];
            assert_eq!(found, expected(x), "{value} {x:?}");
        }
    }
}

fn sign(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

fn chosen(first: bool) -> f64 {
    if first { 1.0 } else { 2.0 }
}

fn largest(first: bool, x: [f64; 2]) -> [f64; 2] {
    if first { [sign(x[0]), 0.0] } else { [0.0, sign(x[1])] }
}

/// Returns the problem of a derivative by `by` of a function with these parameters, result and body.
fn problem(parameters: &str, result: &str, body: &str, by: usize, declared: &str) -> String {
    let text = format!(
        "module demo\nfile \"demo.rs\"\n\
         struct Pair in demo {{ first: f64, second: {declared} }}\n\
         fn subject in demo({parameters}) -> {result} as result {{\n{body}\n}}\n\
         fn jacobian in demo({parameters}) -> Pair as result {{\n}}\n"
    );
    let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    let (of, into) = (find(&module, "subject"), find(&module, "jacobian"));
    match derivative(&module, &Request { of, by: vec![by], kind: Kind::Jacobians, into }) {
        Ok(_) => "no problem".to_owned(),
        Err(problem) => problem.message,
    }
}

/// Each reason why a function has no derivative is reported, and so is a signature that does not fit.
#[test]
fn functions_without_a_derivative_are_refused() {
    let plain = "return x;";
    let cases = [
        ("x: f64, n: usize", "f64", plain, 1, "f64", "`n` is no f64"),
        ("x: &mut f64", "f64", plain, 0, "f64", "`subject` writes through `x`"),
        ("x: f64", "f64", plain, 0, "matrix<f64, 2, 1>", "another result than the value"),
        ("x: f64, b: bool", "bool", "return b;", 0, "f64", "parts that are no floats"),
        (
            "x: f64",
            "f64",
            "return x.to_bits() as f64;",
            0,
            "f64",
            "an operation on the bits of a differentiated number",
        ),
        (
            "x: f64, n: usize",
            "f64",
            "for i: usize in 0..n { if x > 1.0 { return x; } }\nreturn x;",
            0,
            "f64",
            "a `return` within a long loop",
        ),
        ("x: f64", "f64", "let a: [f64; 2] = [x, x];\nreturn a[2];", 0, "f64", "out of range"),
    ];
    for (parameters, result, body, by, declared, expected) in cases {
        let found = problem(parameters, result, body, by, declared);
        assert!(found.contains(expected), "{body}: {found}");
    }
}
