//! Propagation of covariances: F P Fᵀ in place equals the product of dense matrices, for random structures of F.

use bessemer_derivative::{Kind, Request, derivative};
use bessemer_interpret::Interpreter;
use bessemer_ir::Module;
use bessemer_ir::text::parse;

use crate::find;
use crate::programs::Random;

/// Number of states.
const SIZE: usize = 6;

/// Number of random structures; with `BESSEMER_FULL` ten times as many.
const STRUCTURES: u64 = 200;

/// Returns a module with a step of random structure, its Jacobian and its propagation. With `seed` small the structures are the
/// identity, a chain, a ring and a permutation.
fn module(seed: u64) -> Module {
    let mut random = Random(seed.wrapping_mul(0x9E37_79B9).wrapping_add(3));
    let mut rows = Vec::new();
    for row in 0..SIZE {
        let mut terms = Vec::new();
        for column in 0..SIZE {
            let is_there = match seed {
                0 => row == column,
                1 => row == column || row + 1 == column,
                2 => row == column || (row + 1) % SIZE == column,
                3 => (row + 2) % SIZE == column,
                _ => random.below(10) < 3 || row == column && random.below(4) > 0,
            };
            let of = format!("x[{column}, 0]");
            terms.extend(is_there.then(|| match if row == column { seed % 3 } else { seed } {
                0 => of,
                _ => match random.below(4) {
                    0 => of,
                    1 => format!("-{of}"),
                    2 => format!("y * {of}"),
                    _ => format!("{of} * {of}"),
                },
            }));
        }
        rows.push(if terms.is_empty() { "0.5".to_owned() } else { terms.join(" + ") });
    }
    let (vector, matrix) =
        (format!("matrix<f64, {SIZE}, 1>"), format!("matrix<f64, {SIZE}, {SIZE}>"));
    let text = format!(
        "module demo\n\
         struct Pair in demo {{ first: {vector}, second: {matrix} }}\n\
         struct Covariance in demo {{ elements: {matrix} }}\n\
         fn subject in demo(x: &{vector}, y: f64) -> {vector} as result {{\n\
           return matrix<{SIZE}, 1>({});\n\
         }}\n\
         fn jacobian in demo(x: &{vector}, y: f64) -> Pair as result {{\n\
           return struct Pair {{ first: x, second: splat<{SIZE}, {SIZE}>(0.0) }};\n\
         }}\n\
         fn propagated in demo(x: &{vector}, y: f64, p: &mut Covariance) -> {vector} as result {{\n\
           return x;\n\
         }}\n",
        rows.join(", ")
    );
    parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"))
}

/// Runs the derivative that a function declares; returns its result, and its arguments afterwards.
fn run(module: &Module, name: &str, mut arguments: Vec<Vec<u64>>) -> (Vec<f64>, Vec<Vec<u64>>) {
    let (of, into) = (find(module, "subject"), find(module, name));
    let request = Request { of, by: vec![0], kind: Kind::Jacobians, into };
    let (mut with, function) =
        derivative(module, &request).unwrap_or_else(|problem| panic!("{}", problem.message));
    with.functions[into.index()] = function;
    let found = Interpreter::new(&with).call(into, &mut arguments).expect("it runs");
    (found.into_iter().map(f64::from_bits).collect(), arguments)
}

#[test]
fn covariances_are_propagated_as_by_dense_matrices() {
    let full = std::env::var_os("BESSEMER_FULL").is_some();
    for seed in 0..if full { 10 * STRUCTURES } else { STRUCTURES } {
        let module = module(seed);
        let mut random = Random(seed + 11);
        let mut number = || random.below(2001) as f64 * 1e-3 - 1.0;
        let state: Vec<u64> = (0..SIZE).map(|_| number().to_bits()).collect();
        let y = vec![number().to_bits()];
        let mut p = [[0.0; SIZE]; SIZE];
        for at in 0..SIZE * SIZE {
            let (row, column) = (at / SIZE, at % SIZE);
            p[row][column] = if column <= row { number() } else { 0.0 };
        }
        for at in 0..SIZE * SIZE {
            let (row, column) = (at / SIZE, at % SIZE);
            p[row.min(column)][row.max(column)] = p[row.max(column)][row.min(column)];
        }
        let arguments = vec![state.clone(), y.clone()];
        let (dense, _) = run(&module, "jacobian", arguments.clone());
        let f = |row: usize, column: usize| dense[SIZE + row + SIZE * column];
        let words = p.iter().flatten().map(|it| it.to_bits()).collect();
        let (value, after) = run(&module, "propagated", vec![state, y, words]);
        assert_eq!(value, dense[..SIZE], "{seed}");
        let found = |row: usize, column: usize| after[2][row + SIZE * column];
        for row in 0..SIZE {
            for column in 0..SIZE {
                assert_eq!(found(row, column), found(column, row), "{seed}: ({row}, {column})");
                let all = (0..SIZE).flat_map(|k| (0..SIZE).map(move |l| (k, l)));
                let wanted: f64 = all.map(|(k, l)| f(row, k) * p[k][l] * f(column, l)).sum();
                let found = f64::from_bits(found(row, column));
                assert!(
                    (found - wanted).abs() < 1e-12,
                    "{seed}: ({row}, {column}) is {found:e}, not {wanted:e}"
                );
            }
        }
    }
}

/// Each signature that propagates nothing is refused.
#[test]
fn a_covariance_that_does_not_fit_is_refused() {
    let vector = "matrix<f64, 2, 1>";
    let cases = [
        ("p: &mut matrix<f64, 3, 3>", vector, vector, "`p` is no covariance of the 2 numbers"),
        ("p: &mut matrix<f32, 2, 2>", vector, vector, "`p` is no covariance of the 2 numbers"),
        ("p: &mut Two", vector, vector, "`p` is no covariance of the 2 numbers"),
        ("p: &mut matrix<f64, 2, 2>", vector, "f64", "another result than `subject`"),
        ("p: &matrix<f64, 2, 2>", vector, vector, "does not have the parameters"),
        ("p: &mut matrix<f64, 2, 2>", "f64", "f64", "is no state of the size of `x`"),
    ];
    for (covariance, result, declared, expected) in cases {
        let value = if result == "f64" { "x[0, 0]" } else { "x" };
        let text = format!(
            "module demo\nfile \"demo.rs\"\n\
             struct Two in demo {{ first: matrix<f64, 2, 2>, second: f64 }}\n\
             fn subject in demo(x: &{vector}) -> {result} as result {{\nreturn {value};\n}}\n\
             fn jacobian in demo(x: &{vector}, {covariance}) -> {declared} as result {{\n}}\n"
        );
        let module = parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let (of, into) = (find(&module, "subject"), find(&module, "jacobian"));
        let found =
            match derivative(&module, &Request { of, by: vec![0], kind: Kind::Jacobians, into }) {
                Ok(_) => "no problem".to_owned(),
                Err(problem) => problem.message,
            };
        assert!(found.contains(expected), "{covariance}: {found}");
    }
}
