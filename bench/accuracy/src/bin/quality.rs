//! Accuracy of the linear-algebra solutions, compared with LAPACK's, against references of eighty digits.
//!
//! `cargo run --release --manifest-path bench/accuracy/Cargo.toml --bin quality` writes
//! `bench/results/quality.json` and `bench/results/quality.md`. What runs is the DSL's own Rust, whose bits
//! the C has (tests/tests/linear.rs); of the fast mode, whose bits are its own, the C. LAPACK is a program beside it
//! (`bench/c/quality.c`, gcc, -llapack).

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use bessemer::linear::kernels::{cholesky_lower, cholesky_solve_mut};
use bessemer::prelude::*;
use bessemer_backend::kernels::{Mode, Processors, Tuning};
use bessemer_ir::KernelRoutine;
use bessemer_legs::kernels::{Program, kernel};
use bessemer_legs::toolchain::{self, Toolchain};
use rug::Float;

/// Precision of the reference, in bits: eighty decimal digits.
const PRECISION: u32 = 266;
/// Number of systems of each kind and size.
const SYSTEMS: u64 = 40;

/// Settings for the C of the fast mode, for more than twenty rows on a processor with fused multiply-add.
const FAST: Tuning =
    Tuning { code_bytes: 8 * 1024, mode: Mode::Fast, processors: Processors::Every };
const FUSING: Toolchain = Toolchain { level: 3, more: &["-march=native"], ..toolchain::GCC };
const FAST_SIZE: usize = 33;
const FAST_SOLVE: &str = "solve, fast mode";
const FAST_INVERSE: &str = "inverse, fast mode";

/// Name of the inverse as the solution of `A X = I`, the most accurate of the methods for four rows.
const BY_SOLVING: &str = "solve with I";

/// Classes of matrices.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Random,
    Graded,
    Hilbert,
    NearSingular,
    Definite,
}

const KINDS: [(Kind, &str); 5] = [
    (Kind::Random, "random, in [−1, 1]"),
    (Kind::Graded, "rows from 10⁻¹² to 1"),
    (Kind::Hilbert, "like Hilbert's"),
    (Kind::NearSingular, "a column is 10⁻¹³ off the sum of two"),
    (Kind::Definite, "random, symmetric, definite"),
];

/// A random generator: xorshift64*.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(2_685_821_657_736_338_717) >> 11) as f64 / 2f64.powi(52) - 1.0
    }
}

fn matrix<const N: usize>(kind: Kind, random: &mut Random) -> SMatrix<f64, N, N> {
    let mut a = SMatrix::<f64, N, N>::from_fn(|_, _| random.unit());
    match kind {
        Kind::Random => {}
        Kind::Graded => {
            for row in 0..N {
                a.row_mut(row).scale_mut(10f64.powf(-12.0 * row as f64 / (N - 1) as f64));
            }
        }
        Kind::Hilbert => {
            let shift = random.unit().abs();
            a = SMatrix::from_fn(|row, column| 1.0 / ((row + column + 1) as f64 + shift));
        }
        Kind::NearSingular => {
            let near = a.column(0) + a.column(1) + SVector::from_fn(|_, _| 1e-13 * random.unit());
            a.set_column(N - 1, &near);
        }
        Kind::Definite => {
            a = a * a.transpose();
            a += SMatrix::identity() * 1e-3;
            a = SMatrix::from_fn(|row, column| a[(row.max(column), row.min(column))]);
        }
    }
    a
}

/// LAPACK in a separate process.
struct Lapack(Child, BufReader<std::process::ChildStdout>);

impl Lapack {
    fn start(root: &Path, folder: &Path) -> Lapack {
        let program = folder.join("quality-lapack");
        let source = root.join("bench/c/quality.c");
        let status = Command::new("gcc")
            .args(["-std=c99", "-O2"])
            .arg(source)
            .arg("-o")
            .arg(&program)
            .args(["-llapack", "-lblas"])
            .status();
        assert!(status.is_ok_and(|status| status.success()), "gcc or LAPACK is missing");
        let mut child = Command::new(program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("it was just compiled");
        let answers = BufReader::new(child.stdout.take().expect("piped"));
        Lapack(child, answers)
    }

    fn ask(&mut self, routine: &str, n: usize, a: &[f64], b: &[f64]) -> Vec<f64> {
        let mut request = format!("{routine} {n}");
        for number in a.iter().chain(b) {
            let _ = write!(request, " {:x}", number.to_bits());
        }
        let requests = self.0.stdin.as_mut().expect("piped");
        writeln!(requests, "{request}").and_then(|()| requests.flush()).expect("it lives");
        let mut answer = String::new();
        self.1.read_line(&mut answer).expect("it lives");
        let word = |word: &str| f64::from_bits(u64::from_str_radix(word, 16).expect("a word"));
        answer.split_whitespace().map(word).collect()
    }
}

/// The solution of a system to eighty digits, by elimination with row pivoting.
fn truth(n: usize, a: &[f64], b: &[f64]) -> Vec<Float> {
    let exact = |value: &f64| Float::with_val(PRECISION, *value);
    let mut a: Vec<Float> = a.iter().map(exact).collect();
    let mut b: Vec<Float> = b.iter().map(exact).collect();
    for k in 0..n {
        let larger = |&x: &usize, &y: &usize| {
            a[x + n * k].cmp_abs(&a[y + n * k]).unwrap_or(std::cmp::Ordering::Equal)
        };
        let pivot = (k..n).max_by(larger).unwrap_or(k);
        (0..n).for_each(|column| a.swap(k + n * column, pivot + n * column));
        b.swap(k, pivot);
        for row in k + 1..n {
            let factor = Float::with_val(PRECISION, &a[row + n * k] / &a[k + n * k]);
            for column in k..n {
                let product = Float::with_val(PRECISION, &factor * &a[k + n * column]);
                a[row + n * column] -= product;
            }
            let product = Float::with_val(PRECISION, &factor * &b[k]);
            b[row] -= product;
        }
    }
    for k in (0..n).rev() {
        for column in k + 1..n {
            let product = Float::with_val(PRECISION, &a[k + n * column] * &b[column]);
            b[k] -= product;
        }
        b[k] /= a[k + n * k].clone();
    }
    b
}

/// Returns the largest residual of a system over `ε (‖A‖ ‖x‖ + ‖b‖)`, and the relative error of its solution. Both are
/// computed in eighty digits.
fn errors(n: usize, a: &[f64], b: &[f64], x: &[f64], truth: &[Float]) -> [f64; 2] {
    let mut residual: f64 = 0.0;
    for row in 0..n {
        let mut rest = Float::with_val(PRECISION, b[row]);
        for column in 0..n {
            let product = Float::with_val(PRECISION, a[row + n * column]) * x[column];
            rest -= product;
        }
        residual = residual.max(rest.to_f64().abs());
    }
    let sum = |row: usize| (0..n).map(|column| a[row + n * column].abs()).sum::<f64>();
    let norm_a = (0..n).map(sum).fold(0.0, f64::max);
    let norm = |list: &[f64]| list.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
    let scale = f64::EPSILON * (norm_a * norm(x) + norm(b));
    let off =
        x.iter().zip(truth).map(|(x, truth)| Float::with_val(PRECISION, x - truth).to_f64().abs());
    let size = truth.iter().map(|value| value.to_f64().abs()).fold(0.0, f64::max);
    [residual / scale, off.fold(0.0, f64::max) / size]
}

/// Residuals and errors of one kind and size, ours and LAPACK's.
#[derive(Default)]
struct Findings {
    ours: Vec<[f64; 2]>,
    theirs: Vec<[f64; 2]>,
}

/// Other implementations: LAPACK, and the C of the fast mode, unless this processor has none.
struct Others {
    lapack: Lapack,
    fast: Option<Program>,
}

impl Others {
    fn start(root: &Path) -> Others {
        let lapack = Lapack::start(root, &std::env::temp_dir());
        let kernels = [fast_kernel(FAST_SOLVE), fast_kernel(FAST_INVERSE)];
        let fast = std::arch::is_x86_feature_detected!("fma")
            .then(|| Program::start(&kernels, FAST, &FUSING));
        Others { lapack, fast }
    }

    fn fast(&mut self, routine: &str, arguments: &[&[f64]], count: usize) -> Vec<f64> {
        let fast = self.fast.as_mut().expect("asked only where there is one");
        fast.solve(&fast_kernel(routine), arguments, count)
    }
}

fn fast_kernel(routine: &str) -> bessemer_ir::Kernel {
    let (routine, dims): (_, &[usize]) = match routine {
        FAST_SOLVE => (KernelRoutine::Solve, &[FAST_SIZE, 1]),
        _ => (KernelRoutine::Inverse, &[FAST_SIZE]),
    };
    kernel(routine, bessemer_ir::Float::F64, dims)
}

fn systems<const N: usize>(routine: &str, kind: Kind, others: &mut Others) -> Findings {
    let mut findings = Findings::default();
    for system in 0..SYSTEMS {
        let mut random =
            Random(0x9E37_79B9_7F4A_7C15 ^ (system + 1).wrapping_mul(0xD1B5_4A32_D192_ED03));
        let a = matrix::<N>(kind, &mut random);
        let b = SVector::<f64, N>::from_fn(|_, _| random.unit());
        let asked = match routine {
            BY_SOLVING | FAST_INVERSE => "inverse",
            FAST_SOLVE => "solve",
            _ => routine,
        };
        let theirs = others.lapack.ask(asked, N, a.as_slice(), b.as_slice());
        let mut check = |ours: &[f64], theirs: &[f64], b: &[f64]| {
            let truth = truth(N, a.as_slice(), b);
            findings.ours.push(errors(N, a.as_slice(), b, ours, &truth));
            findings.theirs.push(errors(N, a.as_slice(), b, theirs, &truth));
        };
        match routine {
            "solve" => {
                let mut x = b;
                assert!(bessemer::solve_into(&a, &mut x), "not singular");
                check(x.as_slice(), &theirs, b.as_slice());
            }
            FAST_SOLVE => {
                let x = others.fast(routine, &[a.as_slice(), b.as_slice()], N);
                check(&x, &theirs, b.as_slice());
            }
            "definite" => {
                let (factor, mut x) = (cholesky_lower(&a), b);
                if factor[(0, 0)] > 0.0 {
                    cholesky_solve_mut(&factor, &mut x);
                    check(x.as_slice(), &theirs, b.as_slice());
                }
            }
            _ => {
                let inverse = inverse(routine, &a, others);
                for column in 0..N {
                    let mut unit = [0.0; N];
                    unit[column] = 1.0;
                    let ours = &inverse[N * column..N * (column + 1)];
                    check(ours, &theirs[N * column..N * (column + 1)], &unit);
                }
            }
        }
    }
    findings
}

/// Computes the inverse; elements are by columns.
fn inverse<const N: usize>(routine: &str, a: &SMatrix<f64, N, N>, others: &mut Others) -> Vec<f64> {
    let mut inverse = if routine == BY_SOLVING { SMatrix::identity() } else { *a };
    let found = match routine {
        FAST_INVERSE => return others.fast(routine, &[a.as_slice()], N * N),
        BY_SOLVING => bessemer::solve_into(a, &mut inverse),
        _ => bessemer::inverse_mut(&mut inverse),
    };
    assert!(found, "not singular");
    inverse.as_slice().to_vec()
}

fn worst(list: &[[f64; 2]], which: usize) -> f64 {
    list.iter().map(|pair| pair[which]).fold(0.0, f64::max)
}

fn median(list: &[[f64; 2]], which: usize) -> f64 {
    let mut values: Vec<f64> = list.iter().map(|pair| pair[which]).collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or_default()
}

/// Formats a line of the table and an object of the JSON.
fn report(routine: &str, n: usize, kind: &str, findings: &Findings) -> (String, Option<String>) {
    let both = [&findings.ours, &findings.theirs];
    let count = both[0].len();
    if count == 0 {
        return (format!("| {routine} | {n} | {kind} | 0 |{}\n", " – |".repeat(8)), None);
    }
    let of = |figure: fn(&[[f64; 2]], usize) -> f64, which| both.map(|list| figure(list, which));
    let (mut line, mut object) = (
        format!("| {routine} | {n} | {kind} | {count} |"),
        format!(
            "  {{\"routine\": \"{routine}\", \"size\": {n}, \"kind\": \"{kind}\", \"solutions\": {count}"
        ),
    );
    for (name, [ours, theirs]) in [("worst", of(worst, 0)), ("median", of(median, 0))] {
        let _ = write!(line, " {ours:.3} | {theirs:.3} |");
        let _ = write!(object, ", \"{name}_residual\": [{ours:.4}, {theirs:.4}]");
    }
    for (name, [ours, theirs]) in [("worst", of(worst, 1)), ("median", of(median, 1))] {
        let _ = write!(line, " {ours:.1e} | {theirs:.1e} |");
        let _ = write!(object, ", \"{name}_error\": [{ours:.3e}, {theirs:.3e}]");
    }
    (line + "\n", Some(object + "}"))
}

fn main() {
    let root: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut others = Others::start(&root);
    let (mut rows, mut json) = (String::new(), Vec::new());
    for routine in ["solve", FAST_SOLVE, "inverse", FAST_INVERSE, BY_SOLVING, "definite"] {
        for (kind, name) in KINDS {
            let mut take = |n: usize, findings: &Findings| {
                let (row, object) = report(routine, n, name, findings);
                rows += &row;
                json.extend(object);
            };
            let definite = matches!(kind, Kind::Definite | Kind::Hilbert);
            match routine {
                FAST_SOLVE | FAST_INVERSE if others.fast.is_none() => {}
                FAST_SOLVE | FAST_INVERSE => {
                    take(FAST_SIZE, &systems::<FAST_SIZE>(routine, kind, &mut others));
                }
                BY_SOLVING => take(4, &systems::<4>(routine, kind, &mut others)),
                "definite" if !definite => {}
                _ => {
                    take(4, &systems::<4>(routine, kind, &mut others));
                    take(6, &systems::<6>(routine, kind, &mut others));
                    take(12, &systems::<12>(routine, kind, &mut others));
                    take(33, &systems::<33>(routine, kind, &mut others));
                }
            }
        }
    }
    let text = format!("{}{rows}", HEAD.replace("SYSTEMS", &SYSTEMS.to_string()));
    println!("{text}");
    let write =
        |name: &str, text: &str| std::fs::write(root.join("bench/results").join(name), text);
    write("quality.md", &text)
        .and_then(|()| write("quality.json", &format!("[\n{}\n]\n", json.join(",\n"))))
        .expect("bench/results is there");
}

const HEAD: &str = "\
# How good the solutions are

Written by `cargo run --release --manifest-path bench/accuracy/Cargo.toml --bin quality`;
[quality.json](quality.json) has the same figures. SYSTEMS matrices of each kind and size, f64. A residual is
`‖b − A x‖ / (ε (‖A‖ ‖x‖ + ‖b‖))`, norms of rows, an error `‖x − x*‖ / ‖x*‖`, both in 80 digits, with the
true solution `x*` in 80 digits. Ours are those of the emitted C, bit for bit; beside them LAPACK's (dgesv,
dgetrf and dgetri, dposv) on the same numbers. In the fast mode they are those of its C as gcc makes it with
`-O3 -march=native`, on a processor that fuses; up to 20 rows it is the exact mode.
Inverses of up to four rows go by cofactors, as nalgebra's do;
`solve with I` is `bessemer::solve(&a, &SMatrix::identity())`, the inverse by elimination.
`solutions`: how many there are, a column of an inverse being one; a matrix that rounding makes indefinite has none.
Residuals of inverses are those of `A X = I`; dgetri is made for `X A = I`, so compare errors there.

| routine | size | matrices | solutions | residual, worst: ours | LAPACK's | median: ours | LAPACK's | error, worst: ours | LAPACK's | median: ours | LAPACK's |
|---|---|---|---|---|---|---|---|---|---|---|---|
";
