//! The fast mode of kernels. Errors are within the bounds of the report and the C, element by element, in both types,
//! with gcc and clang, AVX and AVX-512, and NEON for products of `f32`. Solutions are as good as the exact mode's;
//! where a target gains nothing, the bits are the exact mode's.
//!
//! The bounds are Higham's (*Accuracy and Stability of Numerical Algorithms*, second edition), with `u` half a unit in the
//! last place of 1 and `γ(n) = n u / (1 − n u)`: `|P A − L U| ≤ γ(n) |L| |U|` (theorem 9.3), `|b − A x| ≤ γ(3 n) |L| |U| |x|`
//! (theorem 9.4), `|C − A B| ≤ γ(n) |A| |B|` (section 3.5). L and U are those that the kernel `lu_solve` of the size gives.

use bessemer_backend::kernels::{Mode, Processors, Tuning};
use bessemer_ir::{Float, Kernel, KernelRoutine};
use bessemer_tests::kernels::{Program, kernel, number, word};
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::turn;

use KernelRoutine::{Inverse, LuSolve, Product, ProductTr, Solve, TrProduct};

const FAST: Tuning =
    Tuning { code_bytes: 8 * 1024, mode: Mode::Fast, processors: Processors::Every };
const EXACT: Tuning = Tuning { mode: Mode::Exact, ..FAST };

/// Right-hand sides of the solves of many.
const SIDES: usize = 9;

/// Returns the largest relative error of a number of roundings.
fn gamma(roundings: usize, element: Float) -> f64 {
    let unit = match element {
        Float::F64 => 2f64.powi(-53),
        Float::F32 => 2f64.powi(-24),
    };
    let error = roundings as f64 * unit;
    error / (1.0 - error)
}

/// A generator of numbers; the same in every run.
struct Random(u64);

impl Random {
    /// From −1 to 1, a number of the type.
    fn unit(&mut self, element: Float) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        let value = (self.0 >> 11) as f64 * 2f64.powi(-52) - 1.0;
        number(word(value, element), element)
    }

    fn list(&mut self, count: usize, element: Float) -> Vec<f64> {
        (0..count).map(|_| self.unit(element)).collect()
    }
}

/// `x` times `y` less `known`, and the sum of the magnitudes of the products; in twice the precision of `f64`.
fn difference(
    x: impl Iterator<Item = f64>,
    y: impl Iterator<Item = f64>,
    known: f64,
) -> (f64, f64) {
    let (mut high, mut low, mut size) = (-known, 0.0, 0.0);
    for (x, y) in x.zip(y) {
        let product = x * y;
        low += x.mul_add(y, -product);
        let sum = high + product;
        let part = sum - high;
        low += (high - (sum - part)) + (product - part);
        high = sum;
        size += product.abs();
    }
    ((high + low).abs(), size)
}

/// Returns |L| |U|, its rows in the order of the factorised matrix, and the largest ratio of |P A − L U| to its bound.
fn growth(n: usize, a: &[f64], factors: &[f64], element: Float) -> (Vec<f64>, f64) {
    let mut open: Vec<usize> = (0..n).collect();
    let (mut bounds, mut worst) = (vec![0.0; n * n], 0.0f64);
    for row in 0..n {
        let lower = |k: usize| if k == row { 1.0 } else { factors[row + n * k] };
        let terms = |column: usize| {
            let known = 0..=row.min(column);
            (known.clone().map(lower), known.map(move |k| factors[k + n * column]))
        };
        let line: Vec<f64> = (0..n)
            .map(|column| {
                let (left, right) = terms(column);
                left.zip(right).map(|(x, y)| x * y).sum()
            })
            .collect();
        // The row of the matrix that this row of the factors comes from: the nearest.
        let off = |of: usize| {
            let off = line.iter().enumerate().map(|(at, it)| (it - a[of + n * at]).abs());
            off.fold(0.0, f64::max)
        };
        let nearest = (0..open.len()).min_by(|x, y| off(open[*x]).total_cmp(&off(open[*y])));
        let of = open.swap_remove(nearest.expect("as many as rows"));
        for column in 0..n {
            let (left, right) = terms(column);
            let (off, size) = difference(left, right, a[of + n * column]);
            bounds[of + n * column] = size;
            worst = worst.max(off / (gamma(n, element) * size));
        }
    }
    (bounds, worst)
}

/// Returns the largest ratio of |b − A x| to its bound, and its largest element relative to ‖A‖ ‖x‖ + ‖b‖.
fn residual(a: &[f64], bounds: &[f64], b: &[f64], x: &[f64], element: Float) -> [f64; 2] {
    let n = b.len();
    let (mut part, mut largest, mut norm) = (0.0f64, 0.0f64, 0.0f64);
    for row in 0..n {
        let line = || (0..n).map(|column| a[row + n * column]);
        let (off, _) = difference(line(), x.iter().copied(), b[row]);
        let line_of_bounds = (0..n).map(|column| bounds[row + n * column]);
        let (_, size) = difference(line_of_bounds, x.iter().copied(), 0.0);
        part = part.max(off / (gamma(3 * n, element) * size));
        largest = largest.max(off);
        norm = norm.max(line().map(f64::abs).sum());
    }
    let size = |list: &[f64]| list.iter().fold(0.0f64, |most, it| most.max(it.abs()));
    [part, largest / (norm * size(x) + size(b))]
}

/// The kernels that solve systems of a size.
fn solvers(element: Float, n: usize) -> [Kernel; 4] {
    [
        kernel(LuSolve, element, &[n, 1]),
        kernel(Solve, element, &[n, 1]),
        kernel(Solve, element, &[n, SIDES]),
        kernel(Inverse, element, &[n]),
    ]
}

/// Sizes that are no multiple of a tile, of a panel, and multiples of both.
const SIZES: [(Float, usize); 7] = [
    (Float::F64, 21),
    (Float::F64, 50),
    (Float::F64, 64),
    (Float::F64, 131),
    (Float::F32, 22),
    (Float::F32, 45),
    (Float::F32, 128),
];

/// Solves systems of a size, and inverts; the largest part of a bound, and the largest relative residual.
fn systems(program: &mut Program, element: Float, n: usize) -> [f64; 2] {
    let [lu, one, many, inverse] = solvers(element, n);
    let mut random = Random(0x9E37_79B9_7F4A_7C15 + n as u64);
    let mut found = [0.0f64; 2];
    for graded in [false, true] {
        let mut a = random.list(n * n, element);
        if graded {
            // Rows from 1 down to 2⁻³⁰: what is small next to the others must be right by itself.
            let scale = |row: usize| 2f64.powi(-((30 * row / n) as i32));
            a.iter_mut().enumerate().for_each(|(at, number)| *number *= scale(at % n));
        }
        let b = random.list(n * SIDES, element);
        let solved = program.solve(&lu, &[&a, &b[..n]], n * n + n);
        let (bounds, part) = growth(n, &a, &solved[..n * n], element);
        found[0] = found[0].max(part);
        let mut check = |b: &[f64], x: &[f64]| {
            let off = residual(&a, &bounds, b, x, element);
            found = [found[0].max(off[0]), found[1].max(off[1])];
        };
        // The check sees errors: what four million roundings could make of one number is far beyond the bound.
        let mut wrong = solved[n * n..].to_vec();
        wrong[0] *= 1.0 + gamma(1 << 22, element);
        assert!(residual(&a, &bounds, &b[..n], &wrong, element)[0] > 1.0, "{element:?} {n}");
        check(&b[..n], &solved[n * n..]);
        check(&b[..n], &program.solve(&one, &[&a, &b[..n]], n));
        let x = program.solve(&many, &[&a, &b], n * SIDES);
        b.chunks(n).zip(x.chunks(n)).for_each(|(b, x)| check(b, x));
        let x = program.solve(&inverse, &[&a], n * n);
        for (column, x) in x.chunks(n).enumerate() {
            let unit: Vec<f64> = (0..n).map(|row| f64::from(row == column)).collect();
            check(&unit, x);
        }
    }
    found
}

/// gcc with the widest vectors and with AVX, clang with the widest; none where this machine does not fuse.
fn fusing() -> Vec<Toolchain> {
    if !std::arch::is_x86_feature_detected!("fma") {
        println!("left out: this processor does not fuse");
        return Vec::new();
    }
    let hosts = toolchain::host().into_iter().filter(|it| it.level == 2);
    let with = |it: Toolchain| {
        let flags: &[&'static [&'static str]] = match it.compiler {
            "gcc" => &[&["-march=native"], &["-march=x86-64-v3"]],
            _ => &[&["-march=native"]],
        };
        flags.iter().map(|more| Toolchain { more, ..it.clone() }).collect::<Vec<_>>()
    };
    hosts.flat_map(with).collect()
}

#[test]
fn solves_and_inverses_stay_within_their_bound() {
    let sizes = turn::one_of(SIZES.to_vec());
    let kernels: Vec<_> = sizes.iter().flat_map(|(it, n)| solvers(*it, *n)).collect();
    let legs = turn::one_of(fusing());
    let Some(first) = legs.first() else { return };
    let mut exact = Program::start(&kernels, EXACT, first);
    let in_order = |(element, n): &(Float, usize)| systems(&mut exact, *element, *n)[1];
    let in_order: Vec<f64> = sizes.iter().map(in_order).collect();
    for toolchain in legs {
        let mut fast = Program::start(&kernels, FAST, &toolchain);
        for ((element, n), in_order) in sizes.iter().copied().zip(in_order.iter().copied()) {
            let [part, residual] = systems(&mut fast, element, n);
            let leg = format!("{} {element:?} {n}", toolchain.name());
            println!(
                "{leg}: {part:.4} of the bound; residual {residual:.1e}, exact {in_order:.1e}"
            );
            assert!(part <= 1.0, "{leg}: {part} of the bound");
            // What is to be expected is far below the bound: about what the exact mode has.
            assert!(residual <= 2.0 * in_order, "{leg}: {residual}, in the exact mode {in_order}");
        }
    }
}

const PRODUCTS: [(KernelRoutine, [usize; 3]); 6] = [
    (Product, [20, 20, 20]),
    (Product, [9, 9, 9]),
    (Product, [33, 70, 18]),
    (Product, [65, 80, 67]),
    (ProductTr, [12, 31, 7]),
    (TrProduct, [13, 40, 10]),
];

/// The product of numbers between −1 and 1; the largest part of its bound.
fn product(program: &mut Program, kernel: &Kernel, [rows, terms, columns]: [usize; 3]) -> f64 {
    let element = kernel.element;
    let mut random = Random(0xD1B5_4A32_D192_ED03);
    let a = random.list(rows * terms, element);
    let b = random.list(terms * columns, element);
    let words = program.call(kernel, &[&a, &b], rows * columns);
    let mut worst = 0.0f64;
    for (at, word) in words.into_iter().enumerate() {
        let (row, column) = (at % rows, at / rows);
        let left = |k: usize| match kernel.routine {
            TrProduct => a[k + terms * row],
            _ => a[row + rows * k],
        };
        let right = |k: usize| match kernel.routine {
            ProductTr => b[column + columns * k],
            _ => b[k + terms * column],
        };
        let known = number(word, element);
        let (off, size) = difference((0..terms).map(left), (0..terms).map(right), known);
        worst = worst.max(off / (gamma(terms, element) * size));
    }
    worst
}

#[test]
fn products_stay_within_their_bound() {
    let products = turn::some_of(PRODUCTS.to_vec(), 2);
    let of = |element| {
        let kernel = |(routine, dims): &(_, [_; 3])| (kernel(*routine, element, dims), *dims);
        products.iter().map(kernel).collect::<Vec<_>>()
    };
    let mut legs: Vec<_> =
        turn::one_of(fusing()).into_iter().map(|it| (it, vec![Float::F64, Float::F32])).collect();
    // NEON's arithmetic, which the fast mode alone uses, and which flushes subnormals: there are none here.
    let neon = toolchain::target().into_iter().filter(|it| it.level == 2);
    let neon = neon.map(|it| Toolchain { more: &["-mfpu=neon-vfpv3"], ..it });
    legs.extend(neon.map(|it| (it, vec![Float::F32])));
    for (toolchain, elements) in legs {
        let cases: Vec<_> = elements.into_iter().flat_map(of).collect();
        let kernels: Vec<_> = cases.iter().map(|(kernel, _)| kernel.clone()).collect();
        let mut program = Program::start(&kernels, FAST, &toolchain);
        for (kernel, dims) in cases {
            let part = product(&mut program, &kernel, dims);
            println!("{} {}: {part:.4} of the bound", toolchain.name(), kernel.name());
            assert!(part <= 1.0, "{} {}: {part}", toolchain.name(), kernel.name());
        }
    }
}

#[test]
fn without_vectors_nothing_is_faster_nor_different() {
    let (element, n) = (Float::F64, 50);
    let kernels = solvers(element, n);
    let Some(gcc) = toolchain::host().into_iter().find(|it| it.level == 2) else {
        println!("left out: there is no compiler");
        return;
    };
    let plain = Toolchain { more: &["-DBESSEMER_PLAIN"], ..gcc.clone() };
    let mut fast = Program::start(&kernels, FAST, &plain);
    let mut exact = Program::start(&kernels, EXACT, &gcc);
    let mut random = Random(7);
    let (a, b) = (random.list(n * n, element), random.list(n * SIDES, element));
    let [lu, one, many, inverse] = &kernels;
    for (kernel, arguments, count) in [
        (lu, vec![&a[..], &b[..n]], n * n + n),
        (one, vec![&a, &b[..n]], n),
        (many, vec![&a, &b], n * SIDES),
        (inverse, vec![&a], n * n),
    ] {
        let found = fast.call(kernel, &arguments, 1 + count);
        assert_eq!(found, exact.call(kernel, &arguments, 1 + count), "{}", kernel.name());
    }
}
