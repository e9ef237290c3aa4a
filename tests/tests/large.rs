//! Systems of more than 127 rows, for which nalgebra has no static decompositions. Interpreter and C have the bits of
//! `bessemer::inverse_mut` and `bessemer::solve_mut`, which `as_nalgebra/linear.rs` compares with nalgebra's dynamic
//! matrices.

use std::collections::BTreeMap;

use bessemer::math::Real;
use bessemer::nalgebra::SMatrix;
use bessemer_backend::c::Options;
use bessemer_backend::kernels::Tuning;
use bessemer_interpret::Interpreter;
use bessemer_ir::{Float, FunctionId, Kernel, KernelRoutine, Module};
use bessemer_tests::kernels::{self, Program, kernel, number, word};
use bessemer_tests::random::Random;
use bessemer_tests::store::once;
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::{texts, turn};

use KernelRoutine::{Inverse, LuSolve, Solve};

/// Number of kernel variants that a run compiles, of the host's five and the target's two.
const WAYS: usize = 4;
/// Columns of the right-hand sides.
const SIDES: usize = 3;

/// Class of a matrix' elements.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Between −1 and 1.
    Uniform,
    /// Rows of very different sizes.
    Graded,
    /// The last column is the first.
    Singular,
    /// Some elements are zero, NaN or infinite.
    Special,
    /// A NaN stands first where the first pivot is sought, a zero where the second is.
    Undefined,
    /// An infinity is the first pivot, and a column has no number but in its last row.
    Infinite,
    /// So small that reciprocals of pivots are infinite.
    Subnormal,
}

const KINDS: [Kind; 4] = [Kind::Uniform, Kind::Graded, Kind::Singular, Kind::Special];
const UNUSUAL: [Kind; 3] = [Kind::Undefined, Kind::Infinite, Kind::Subnormal];

fn elements(kind: Kind, element: Float, n: usize, random: &mut Random) -> Vec<f64> {
    let mut list: Vec<f64> = (0..n * n).map(|_| random.unit()).collect();
    match kind {
        Kind::Uniform => {}
        Kind::Graded => {
            let scale = |row: usize| 10f64.powi(row as i32 % 16 - 8);
            list.iter_mut().enumerate().for_each(|(at, it)| *it *= scale(at % n));
        }
        Kind::Singular => list.copy_within(..n, n * (n - 1)),
        Kind::Special => {
            // The infinity late, so that the first pivots are numbers.
            list[0] = -0.0;
            list[n + 7] = 5e-324;
            list[n * (n - 2) + n - 3] = f64::INFINITY;
            list[n * (n - 1) + 3] = f64::NAN;
        }
        Kind::Undefined => {
            list[0] = f64::NAN;
            list[n + 1] = 0.0;
        }
        Kind::Infinite => {
            list[5] = f64::NEG_INFINITY;
            list[2 * n..3 * n - 1].fill(f64::NAN);
        }
        Kind::Subnormal => {
            let scale = match element {
                Float::F64 => 1e-310,
                Float::F32 => 1e-40,
            };
            list.iter_mut().for_each(|it| *it *= scale);
        }
    }
    list
}

/// A call, and what Rust makes of it: the result, and the arguments that it changes.
struct Call {
    kernel: Kernel,
    kind: Kind,
    arguments: Vec<Vec<f64>>,
    native: Vec<u64>,
}

fn calls<T: Real, const N: usize>(element: Float) -> Vec<Call> {
    let number = |it: f64| T::dsl_from_f64(it);
    let words = |list: &[T]| list.iter().map(|it| word(it.as_f64(), element)).collect::<Vec<_>>();
    let mut random = Random(0x9E37_79B9_7F4A_7C15 + N as u64);
    let mut calls = Vec::new();
    for kind in KINDS {
        let list = elements(kind, element, N, &mut random);
        let right: Vec<f64> = (0..N * SIDES).map(|_| random.unit()).collect();
        let a: Box<SMatrix<T, N, N>> =
            Box::new(SMatrix::from_iterator(list.iter().copied().map(number)));
        let b: Box<SMatrix<T, N, SIDES>> =
            Box::new(SMatrix::from_iterator(right.iter().copied().map(number)));
        let mut take = |routine, dims: &[usize], arguments: &[&[f64]], found, parts: &[&[T]]| {
            let mut native = vec![u64::from(found)];
            native.extend(parts.iter().flat_map(|part| words(part)));
            let arguments = arguments.iter().map(|list| list.to_vec()).collect();
            calls.push(Call { kernel: kernel(routine, element, dims), kind, arguments, native });
        };
        let mut inverse = a.clone();
        let found = bessemer::inverse_mut(&mut *inverse);
        take(Inverse, &[N], &[&list], found, &[inverse.as_slice()]);
        let mut x = b.clone();
        let found = bessemer::solve_into(&*a, &mut *x);
        take(Solve, &[N, SIDES], &[&list, &right], found, &[x.as_slice()]);
        let (mut factors, mut x) = (a, b);
        let found = bessemer::solve_mut(&mut *factors, &mut *x);
        let parts = [factors.as_slice(), x.as_slice()];
        take(LuSolve, &[N, SIDES], &[&list, &right], found, &parts);
    }
    calls
}

/// Solves for one right-hand side and inverses, of which x86-64 has forms of their own.
fn solves<T: Real, const N: usize>(element: Float) -> Vec<Call> {
    let number = |it: f64| T::dsl_from_f64(it);
    let words = |list: &[T]| list.iter().map(|it| word(it.as_f64(), element)).collect::<Vec<_>>();
    let mut random = Random(0xD1B5_4A32_D192_ED03 + N as u64);
    let calls = |kind| {
        let list = elements(kind, element, N, &mut random);
        let right: Vec<f64> = (0..N).map(|_| random.unit()).collect();
        let mut a: Box<SMatrix<T, N, N>> =
            Box::new(SMatrix::from_iterator(list.iter().copied().map(number)));
        let mut x = SMatrix::<T, N, 1>::from_iterator(right.iter().copied().map(number));
        let mut solved = vec![u64::from(bessemer::solve_into(&*a, &mut x))];
        solved.extend(words(x.as_slice()));
        let mut inverted = vec![u64::from(bessemer::inverse_mut(&mut *a))];
        inverted.extend(words(a.as_slice()));
        let solve = kernel(Solve, element, &[N, 1]);
        let inverse = kernel(Inverse, element, &[N]);
        [
            Call { kernel: solve, kind, arguments: vec![list.clone(), right], native: solved },
            Call { kernel: inverse, kind, arguments: vec![list], native: inverted },
        ]
    };
    KINDS.into_iter().chain(UNUSUAL).flat_map(calls).collect()
}

/// The calls of some of the sizes: of all in a full run.
fn all() -> Vec<Call> {
    let sizes: Vec<fn() -> Vec<Call>> = vec![
        || solves::<f64, 63>(Float::F64),
        || calls::<f64, 130>(Float::F64),
        || solves::<f32, 128>(Float::F32),
        || solves::<f64, 64>(Float::F64),
        || solves::<f64, 132>(Float::F64),
        || calls::<f32, 133>(Float::F32),
        || solves::<f64, 77>(Float::F64),
        || calls::<f64, 132>(Float::F64),
        || solves::<f32, 147>(Float::F32),
        || solves::<f64, 150>(Float::F64),
        || calls::<f64, 150>(Float::F64),
    ];
    turn::some_of(sizes, 2).into_iter().flat_map(|calls| calls()).collect()
}

fn agree(leg: &str, call: &Call, found: &[u64]) {
    let (name, kind, element) = (call.kernel.name(), call.kind, call.kernel.element);
    assert_eq!(found.len(), call.native.len(), "{leg} {name} {kind:?}");
    let is_nan = |word: u64| number(word, element).is_nan();
    for (at, (rust, found)) in call.native.iter().zip(found).enumerate() {
        let same = rust == found || (at > 0 && is_nan(*rust) && is_nan(*found));
        assert!(same, "{leg} {name} {kind:?}, word {at}: {rust:x} in Rust, {found:x}");
    }
}

#[test]
fn the_interpreter_agrees() {
    for call in all() {
        let functions = vec![call.kernel.function()];
        let parameters = functions[0].parameters().to_vec();
        let module = Module { name: "large".into(), functions, ..Module::default() };
        let words =
            |list: &Vec<f64>| list.iter().map(|it| word(*it, call.kernel.element)).collect();
        let mut arguments: Vec<Vec<u64>> = call.arguments.iter().map(words).collect();
        let result = Interpreter::new(&module).call(FunctionId(0), &mut arguments);
        let mut found = result.unwrap_or_else(|stop| panic!("{stop}"));
        for (parameter, words) in parameters.iter().zip(arguments) {
            if parameter.mode == bessemer_ir::Mode::RefMut {
                found.extend(words);
            }
        }
        agree("interpreter", &call, &found);
    }
}

#[test]
fn the_c_agrees() {
    let calls = all();
    let mut kernels: Vec<Kernel> = calls.iter().map(|call| call.kernel.clone()).collect();
    kernels.sort();
    kernels.dedup();
    let more = |it: Toolchain| -> Vec<Toolchain> {
        let flags: &[&'static [&'static str]] = match it.emulator {
            // Loads of four words, and plain C99.
            Some(_) => &[&[], &["-mfpu=neon-vfpv3"]],
            None if toolchain::has_avx2() => &[
                &[],
                &["-mavx2"],
                &["-mavx2", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"],
                &["-march=native"],
                &["-DBESSEMER_PLAIN"],
            ],
            None => &[&[], &["-march=native"], &["-DBESSEMER_PLAIN"]],
        };
        flags.iter().map(|more| Toolchain { more, ..it.clone() }).collect()
    };
    let legs = toolchain::all().into_iter().filter(|it| it.level == 2).flat_map(more);
    // Each way of the kernels once, with a compiler of the turn.
    let ways = legs.fold(BTreeMap::<_, Vec<_>>::new(), |mut ways, it| {
        ways.entry((it.emulator, it.more)).or_default().push(it);
        ways
    });
    let files = kernels::files(&kernels, &Options::default());
    let natives: Vec<_> = calls.iter().map(|call| (&call.kernel, &call.native)).collect();
    let ways = turn::some_of(ways.into_values().collect(), WAYS);
    for toolchain in ways.into_iter().flat_map(turn::one_of) {
        once("large systems", &(texts(&files), &toolchain, &natives), || {
            let mut program = Program::start(&kernels, Tuning::default(), &toolchain);
            for call in &calls {
                let arguments: Vec<&[f64]> = call.arguments.iter().map(Vec::as_slice).collect();
                let found = program.call(&call.kernel, &arguments, call.native.len());
                agree(&toolchain.name(), call, &found);
            }
        });
    }
}
