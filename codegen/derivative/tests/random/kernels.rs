//! Solutions, inverses and determinants of random matrices. Each kernel's value has its bits, and its derivatives are those
//! of an elimination with dual numbers.

use std::fmt::Write as _;

use bessemer_derivative::{Kind, Request, derivative};
use bessemer_interpret::Interpreter;
use bessemer_ir::text::parse;
use bessemer_ir::{FunctionId, KernelRoutine, Module};

use crate::dual::{self, Dual, div, mul, root, sub};
use crate::find;
use crate::programs::{Random, calls};

/// Largest difference from dual numbers, relative to one plus the derivative.
const BOUND: f64 = 1e-11;

/// A matrix of dual numbers by columns.
struct Matrix<'d> {
    rows: usize,
    all: &'d mut Vec<Dual>,
}

impl Matrix<'_> {
    fn at(&self, row: usize, col: usize) -> Dual {
        self.all[row + col * self.rows]
    }

    fn set(&mut self, row: usize, col: usize, value: Dual) {
        self.all[row + col * self.rows] = value;
    }

    fn swap(&mut self, one: usize, other: usize) {
        for col in 0..self.all.len() / self.rows {
            self.all.swap(one + col * self.rows, other + col * self.rows);
        }
    }
}

/// Computes a kernel on its operands, and returns its result.
pub fn run(routine: KernelRoutine, size: usize, operands: &mut [Vec<Dual>]) -> Vec<Dual> {
    use KernelRoutine::*;
    let (first, rest) = operands.split_at_mut(1);
    let before = first[0].clone();
    let mut a = Matrix { rows: size, all: &mut first[0] };
    let mut none = Vec::new();
    let b = rest.first_mut().unwrap_or(&mut none);
    let mut b = Matrix { rows: size, all: b };
    let mut done = true;
    let result = |done: bool| vec![Dual::word(done.into())];
    match routine {
        LuSolve | Solve => {
            done = eliminate(&mut a, &mut b) != 0;
            upper(&a, &mut b, false);
        }
        Inverse => {
            let is_diagonal = |at: usize| at.is_multiple_of(size + 1);
            let one = |at: usize| Dual::new(if is_diagonal(at) { 1.0 } else { 0.0 }, |_| 0.0);
            let mut inverse: Vec<Dual> = (0..size * size).map(one).collect();
            let mut out = Matrix { rows: size, all: &mut inverse };
            done = eliminate(&mut a, &mut out) != 0;
            upper(&a, &mut out, false);
            *a.all = inverse;
        }
        Determinant => {
            let sign = eliminate(&mut a, &mut b);
            let product =
                (0..size).fold(Dual::new(sign.into(), |_| 0.0), |it, k| mul(it, a.at(k, k)));
            *a.all = before;
            return vec![product];
        }
        Cholesky | CholeskyLower => {
            for col in 0..size {
                for row in col..size {
                    let term = |k: usize, a: &Matrix<'_>| mul(a.at(row, k), a.at(col, k));
                    let sum = (0..col).fold(a.at(row, col), |sum, k| sub(sum, term(k, &a)));
                    let of = if row == col { root(sum) } else { div(sum, a.at(col, col)) };
                    a.set(row, col, of);
                }
            }
            if routine == CholeskyLower {
                return std::mem::replace(a.all, before);
            }
        }
        CholeskySolve => {
            lower(&a, &mut b, false);
            upper(&a, &mut b, true);
            return Vec::new();
        }
        SolveLower => lower(&a, &mut b, false),
        SolveUpper => upper(&a, &mut b, false),
        TrSolveLower => upper(&a, &mut b, true),
        TrSolveUpper => lower(&a, &mut b, true),
        other => panic!("{other:?}"),
    }
    if routine == Solve {
        *a.all = before;
    }
    result(done)
}

/// Eliminates with row pivots; returns the sign of the exchanges, or 0.
fn eliminate(a: &mut Matrix<'_>, b: &mut Matrix<'_>) -> i8 {
    let mut sign = 1;
    for k in 0..a.rows {
        let magnitude = |row: usize| a.at(row, k).value().abs();
        let pivot = (k..a.rows).max_by(|x, y| magnitude(*x).total_cmp(&magnitude(*y)));
        let pivot = pivot.unwrap_or(k);
        if a.at(pivot, k).value() == 0.0 {
            return 0;
        }
        if pivot != k {
            sign = -sign;
            a.swap(k, pivot);
            b.swap(k, pivot);
        }
        for row in k + 1..a.rows {
            let factor = div(a.at(row, k), a.at(k, k));
            for col in k..a.rows {
                a.set(row, col, sub(a.at(row, col), mul(factor, a.at(k, col))));
            }
            for col in 0..b.all.len() / a.rows {
                b.set(row, col, sub(b.at(row, col), mul(factor, b.at(k, col))));
            }
        }
    }
    sign
}

fn element(a: &Matrix<'_>, transposed: bool, row: usize, col: usize) -> Dual {
    if transposed { a.at(col, row) } else { a.at(row, col) }
}

/// Solves with a lower triangle, or the transpose of an upper one.
fn lower(a: &Matrix<'_>, b: &mut Matrix<'_>, transposed: bool) {
    triangle(a, b, transposed, &mut |k| (0..k).collect(), (0..a.rows).collect());
}

/// Solves with an upper triangle, or the transpose of a lower one.
fn upper(a: &Matrix<'_>, b: &mut Matrix<'_>, transposed: bool) {
    let size = a.rows;
    triangle(a, b, transposed, &mut |k| (k + 1..size).collect(), (0..size).rev().collect());
}

fn triangle(
    a: &Matrix<'_>,
    b: &mut Matrix<'_>,
    transposed: bool,
    known: &mut dyn FnMut(usize) -> Vec<usize>,
    order: Vec<usize>,
) {
    for col in 0..b.all.len() / a.rows {
        for &k in &order {
            let term =
                |it: usize, b: &Matrix<'_>| mul(element(a, transposed, k, it), b.at(it, col));
            let sum = known(k).into_iter().fold(b.at(k, col), |sum, it| sub(sum, term(it, b)));
            b.set(k, col, div(sum, element(a, transposed, k, k)));
        }
    }
}

/// Returns a module whose `subject` applies a kernel to random matrices of its arguments.
fn module(routine: KernelRoutine, size: usize, seed: u64) -> Module {
    use KernelRoutine::*;
    let mut random = Random(seed.wrapping_mul(0x9E37_79B9).wrapping_add(5));
    let cols = 1 + random.below(2) as usize;
    let mut element = |weight: f64| {
        let variable = ["x[0, 0]", "x[1, 0]", "x[2, 0]", "y", "x[0, 0] * y", "0.5"];
        let of = variable[random.below(6) as usize];
        let part = 0.125 * (random.below(9) as f64 - 4.0);
        format!("({weight:?} + {part:?} * ({of}))").replace("-", "0.0 - ").replace("+ 0.0 -", "-")
    };
    let elements = |list: Vec<String>| list.join(", ");
    let own = |at: usize| if at.is_multiple_of(size + 1) { 4.0 * size as f64 } else { 0.5 };
    let a = elements((0..size * size).map(|at| element(own(at))).collect());
    let b = elements((0..size * cols).map(|_| element(1.0)).collect());
    let (square, right) =
        (format!("matrix<f64, {size}, {size}>"), format!("matrix<f64, {size}, {cols}>"));
    let one = matches!(routine, Inverse | Determinant | Cholesky | CholeskyLower);
    let dims = if one { format!("{size}") } else { format!("{size}, {cols}") };
    let name = routine.name();
    let (parameters, result, body) = match routine {
        Determinant => (format!("a: &{square}"), "f64".to_owned(), format!("return {name}(&a);")),
        Inverse => (
            format!("a: &mut {square}"),
            square.clone(),
            format!("let done: bool = {name}(&mut a);\n if done {{ return a; }}\n return a.neg();"),
        ),
        // A factor solves.
        Cholesky => (
            format!("a: &mut {square}"),
            right.clone(),
            format!(
                "let done: bool = {name}(&mut a);\n if done {{ cholesky_solve(&a, &mut b); }}\n return b;"
            ),
        ),
        CholeskyLower => (
            format!("a: &{square}"),
            right.clone(),
            format!(
                "let l: {square} = {name}(&a);\n if l[0, 0] > 0.0 {{ cholesky_solve(&l, &mut b); }}\n return b;"
            ),
        ),
        LuSolve => (
            format!("a: &mut {square}, b: &mut {right}"),
            right.clone(),
            format!(
                "let done: bool = {name}(&mut a, &mut b);\n if done {{ return b; }}\n return b.neg();"
            ),
        ),
        _ => (
            format!("a: &{square}, b: &mut {right}"),
            right.clone(),
            format!(
                "let done: bool = {name}(&a, &mut b);\n if done {{ return b; }}\n return b.neg();"
            ),
        ),
    };
    let kernel_result = match routine {
        Determinant => "f64".to_owned(),
        CholeskyLower => square.clone(),
        _ => "bool".to_owned(),
    };
    let width = match result.as_str() {
        "f64" => 1,
        it if it == square => size * size,
        _ => size * cols,
    };
    let mut text = "module demo\n".to_owned();
    let _ = writeln!(
        text,
        "struct Triple in demo {{ first: {result}, second: matrix<f64, {width}, 3>, third: {} }}",
        if width == 1 { "f64".to_owned() } else { format!("matrix<f64, {width}, 1>") }
    );
    let _ = writeln!(
        text,
        "fn {name} in demo({parameters}) -> {kernel_result} as result = kernel {name}<f64, {dims}> {{\n}}"
    );
    if matches!(routine, Cholesky | CholeskyLower) {
        let _ = writeln!(
            text,
            "fn cholesky_solve in demo(a: &{square}, b: &mut {right}) = kernel cholesky_solve<f64, {size}, {cols}> {{\n}}"
        );
    }
    let _ = writeln!(
        text,
        "fn subject in demo(x: &matrix<f64, 3, 1>, y: f64, n: usize) -> {result} as result {{\n\
         let a: {square} = matrix<{size}, {size}>({a});\n\
         let b: {right} = matrix<{size}, {cols}>({b});\n{body}\n}}\n\
         fn jacobian in demo(x: &matrix<f64, 3, 1>, y: f64, n: usize) -> Triple as result {{\n}}"
    );
    let squares = match width {
        1 => "r * r".to_owned(),
        _ => {
            let at = |at: usize| format!("r[{0}, {1}] * r[{0}, {1}]", at % size, at / size);
            (0..width).map(at).collect::<Vec<_>>().join(" + ")
        }
    };
    let squares =
        if result == "f64" { squares } else { squares.replace("r * r", "r[0, 0] * r[0, 0]") };
    let _ = writeln!(
        text,
        "struct Slopes in demo {{ first: f64, second: matrix<f64, 3, 1>, third: f64 }}\n\
         fn squared in demo(x: &matrix<f64, 3, 1>, y: f64, n: usize) -> f64 as result {{\n\
         let r: {result} = subject(&x, y, n);\nreturn {squares};\n}}\n\
         fn gradient in demo(x: &matrix<f64, 3, 1>, y: f64, n: usize) -> Slopes as result {{\n}}"
    );
    parse(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"))
}

fn jacobian(module: &Module) -> (Module, FunctionId, FunctionId) {
    let (of, into) = (find(module, "subject"), find(module, "jacobian"));
    let request = Request { of, by: vec![0, 1], kind: Kind::Jacobians, into };
    let (mut with, function) =
        derivative(module, &request).unwrap_or_else(|problem| panic!("{}", problem.message));
    with.functions[into.index()] = function;
    (with, of, into)
}

#[test]
fn kernels_have_the_derivatives_of_dual_numbers() {
    let products = ["product", "product_tr", "tr_product", "tr_mul", "cholesky_solve"];
    let all = KernelRoutine::ALL.into_iter().filter(|it| !products.contains(&it.name()));
    let mut compared = 0;
    for (routine, size) in all.flat_map(|it| (1..=5).map(move |size| (it, size))) {
        for seed in 0..3 {
            let module = module(routine, size, seed);
            let (with, of, into) = jacobian(&module);
            for arguments in calls(seed) {
                let (expected, _) = dual::call(&module, of, &arguments).expect("it is finite");
                let found = Interpreter::new(&with).call(into, &mut arguments.clone());
                let found = found.expect("it runs");
                let plain = Interpreter::new(&module).call(of, &mut arguments.clone());
                let rows = expected.len();
                assert_eq!(found[..rows], plain.expect("it runs")[..], "{routine:?} {size}");
                for (index, word) in found[rows..].iter().enumerate() {
                    let (row, variable) = (index % rows, index / rows);
                    let (found, wanted) = (f64::from_bits(*word), expected[row].tangents[variable]);
                    let difference = (found - wanted).abs();
                    assert!(
                        difference <= BOUND * (1.0 + wanted.abs()),
                        "{routine:?} {size} {seed}: {variable} of {row}: {found:e}, not {wanted:e}"
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// The gradient of a sum of squares goes through a kernel.
#[test]
fn kernels_have_the_gradients_of_dual_numbers() {
    let general = ["lu_solve", "solve", "inverse", "determinant", "cholesky", "cholesky_lower"];
    let triangles = ["solve_lower", "solve_upper", "tr_solve_lower", "tr_solve_upper"];
    let all = general.into_iter().chain(triangles);
    for (name, size) in all.flat_map(|it| (1..=5).map(move |n| (it, n))) {
        let routine = KernelRoutine::from_name(name).expect("it is a kernel");
        for seed in 0..3 {
            let module = module(routine, size, seed);
            let (of, into) = (find(&module, "squared"), find(&module, "gradient"));
            let request = Request { of, by: vec![0, 1], kind: Kind::Gradients, into };
            let found = derivative(&module, &request);
            let (mut derived, function) =
                found.unwrap_or_else(|it| panic!("{name}: {}", it.message));
            derived.functions[into.index()] = function;
            for arguments in calls(seed) {
                let (expected, _) = dual::call(&module, of, &arguments).expect("it is finite");
                let found = Interpreter::new(&derived).call(into, &mut arguments.clone());
                let found = found.expect("it runs");
                let plain = Interpreter::new(&module).call(of, &mut arguments.clone());
                assert_eq!(found[0], plain.expect("it runs")[0], "{name} {size}");
                // The slopes of a determinant grow with its size.
                let scale = 1.0 + expected[0].value().abs();
                for (word, wanted) in found[1..].iter().zip(expected[0].tangents) {
                    let found = f64::from_bits(*word);
                    assert!(
                        (found - wanted).abs() <= BOUND * (scale + wanted.abs()),
                        "{name} {size} {seed}: {found:e}, not {wanted:e}"
                    );
                }
            }
        }
    }
}

/// Without an inverse the matrix stays, and so do its derivatives; the elements of a factor have none.
#[test]
fn a_singular_matrix_keeps_its_derivatives() {
    let square = "matrix<f64, 2, 2>";
    let text = |body: &str| {
        format!(
            "module demo\nfile \"demo.rs\"\n\
             struct Pair in demo {{ first: {square}, second: matrix<f64, 4, 1> }}\n\
             fn inverse in demo(a: &mut {square}) -> bool as result = kernel inverse<f64, 2> {{\n}}\n\
             fn cholesky_lower in demo(a: &{square}) -> {square} as result = kernel cholesky_lower<f64, 2> {{\n}}\n\
             fn subject in demo(x: f64) -> {square} as result {{\n{body}\n}}\n\
             fn jacobian in demo(x: f64) -> Pair as result {{\n}}\n"
        )
    };
    let module = |body: &str| parse(&text(body)).unwrap_or_else(|it| panic!("{it:?}\n{body}"));
    let request = |module: &Module| {
        let (of, into) = (find(module, "subject"), find(module, "jacobian"));
        Request { of, by: vec![0], kind: Kind::Jacobians, into }
    };
    let stays = module(
        "let a: matrix<f64, 2, 2> = matrix<2, 2>(x, x, x * x, x * x);\n\
         let done: bool = inverse(&mut a);\nreturn a;",
    );
    let request_of = request(&stays);
    let (mut with, function) = derivative(&stays, &request_of).expect("it has a derivative");
    with.functions[request_of.into.index()] = function;
    let mut arguments = vec![vec![3.0_f64.to_bits()]];
    let found = Interpreter::new(&with).call(request_of.into, &mut arguments).expect("it runs");
    let found: Vec<f64> = found.into_iter().map(f64::from_bits).collect();
    assert_eq!(found, [3.0, 3.0, 9.0, 9.0, 1.0, 1.0, 6.0, 6.0]);
    let factor = module(
        "let a: matrix<f64, 2, 2> = matrix<2, 2>(x, 0.0, 0.0, x);\n\
         let l: matrix<f64, 2, 2> = cholesky_lower(&a);\nreturn l.add(a);",
    );
    let problem = derivative(&factor, &request(&factor)).expect_err("elements have none");
    assert_eq!(problem.message, "the elements of a factor have no derivative");
}
