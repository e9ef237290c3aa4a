//! Kernels as plain loops over whole matrices, in nalgebra's order of operations.
//!
//! Not modelled: the working memory that the C passes; and no loop is optimised.

use bessemer_ir::kernel::{COFACTORS, Products};
use bessemer_ir::{Float, Kernel, KernelRoutine, Routine};

use super::routine::{Operand, Real, lanes, routine};

/// Computes a kernel from its operands in memory, and writes its result from the address `out` on.
pub(super) fn run(memory: &mut [u64], kernel: &Kernel, operands: &[Operand<'_>], out: usize) {
    match (kernel.routine, kernel.element) {
        (KernelRoutine::Product, _) => routine(memory, Routine::Product, &operands[..2], out),
        (KernelRoutine::ProductTr, _) => {
            let [rows, inner, columns] = [0, 1, 2].map(|dim| kernel.dims[dim] as usize);
            let (a, b) = (operands[0].at, operands[1].at);
            let factors = (|row, k| a + row + rows * k, |k, column| b + column + columns * k);
            product(memory, kernel.element, (rows, inner, columns), factors, out);
        }
        (KernelRoutine::TrProduct, _) => {
            let [rows, inner, columns] = [0, 1, 2].map(|dim| kernel.dims[dim] as usize);
            let (a, b) = (operands[0].at, operands[1].at);
            let factors = (|row, k| a + k + inner * row, |k, column| b + k + inner * column);
            product(memory, kernel.element, (rows, inner, columns), factors, out);
        }
        (KernelRoutine::TrMul, _) => routine(memory, Routine::TrMul, &operands[..2], out),
        (_, Float::F64) => square::<f64>(memory, kernel, operands, out),
        (_, Float::F32) => square::<f32>(memory, kernel, operands, out),
    }
}

/// Computes a product with these numbers of rows, terms and columns; the functions return the addresses of the
/// factors' elements.
fn product(
    memory: &mut [u64],
    element: Float,
    sizes: (usize, usize, usize),
    factors: (impl Fn(usize, usize) -> usize, impl Fn(usize, usize) -> usize),
    out: usize,
) {
    match element {
        Float::F64 => sums::<f64>(memory, sizes, factors, out),
        Float::F32 => sums::<f32>(memory, sizes, factors, out),
    }
}

fn sums<R: Real>(
    memory: &mut [u64],
    (rows, inner, columns): (usize, usize, usize),
    (a, b): (impl Fn(usize, usize) -> usize, impl Fn(usize, usize) -> usize),
    out: usize,
) {
    for column in 0..columns {
        for row in 0..rows {
            let term = |k| R::of(memory[a(row, k)]) * R::of(memory[b(k, column)]);
            let sum = (1..inner).fold(term(0), |sum, k| term(k) + sum);
            memory[out + row + rows * column] = sum.word();
        }
    }
}

/// A matrix in a buffer, by columns.
#[derive(Clone)]
struct Matrix<R> {
    rows: usize,
    elements: Vec<R>,
}

impl<R: Real> Matrix<R> {
    fn read(memory: &[u64], at: usize, rows: usize, cols: usize) -> Matrix<R> {
        let words = &memory[at..at + rows * cols];
        Matrix { rows, elements: words.iter().map(|&word| R::of(word)).collect() }
    }

    fn identity(size: usize) -> Matrix<R> {
        let one = |index: usize| if index.is_multiple_of(size + 1) { R::ONE } else { R::ZERO };
        Matrix { rows: size, elements: (0..size * size).map(one).collect() }
    }

    fn write(&self, memory: &mut [u64], at: usize) {
        for (word, element) in memory[at..].iter_mut().zip(&self.elements) {
            *word = element.word();
        }
    }

    fn cols(&self) -> usize {
        self.elements.len() / self.rows
    }

    fn at(&self, row: usize, col: usize) -> R {
        self.elements[row + self.rows * col]
    }

    fn set(&mut self, row: usize, col: usize, value: R) {
        self.elements[row + self.rows * col] = value;
    }

    fn swap_rows(&mut self, one: usize, other: usize) {
        for col in 0..self.cols() {
            self.elements.swap(one + self.rows * col, other + self.rows * col);
        }
    }

    fn fill(&mut self, value: R) {
        self.elements.iter_mut().for_each(|element| *element = value);
    }
}

/// Computes a routine of a square matrix `a`, or of `a` and `b`.
fn square<R: Real>(memory: &mut [u64], kernel: &Kernel, operands: &[Operand<'_>], out: usize) {
    let size = kernel.dims[0] as usize;
    let at = operands[0].at;
    let mut a = Matrix::<R>::read(memory, at, size, size);
    match kernel.routine {
        KernelRoutine::Product
        | KernelRoutine::ProductTr
        | KernelRoutine::TrProduct
        | KernelRoutine::TrMul => unreachable!("done before"),
        KernelRoutine::LuSolve | KernelRoutine::Solve => {
            let other = operands[1].at;
            let mut b = Matrix::<R>::read(memory, other, size, kernel.dims[1] as usize);
            let solved = solve(&mut a, &mut b);
            if !solved {
                a.fill(R::NAN);
                b.fill(R::NAN);
            }
            if kernel.routine == KernelRoutine::LuSolve {
                a.write(memory, at);
            }
            b.write(memory, other);
            memory[out] = u64::from(solved);
        }
        KernelRoutine::Inverse => {
            let inverse = inverse(a);
            memory[out] = u64::from(inverse.is_some());
            if let Some(inverse) = inverse {
                inverse.write(memory, at);
            }
        }
        KernelRoutine::Determinant => memory[out] = determinant(a).word(),
        KernelRoutine::Cholesky => {
            let factored = cholesky(&mut a);
            memory[out] = u64::from(factored);
            a.write(memory, at);
        }
        KernelRoutine::CholeskyLower => {
            // NaN says that there is none.
            let _ = cholesky(&mut a);
            a.write(memory, out);
        }
        KernelRoutine::CholeskySolve
        | KernelRoutine::SolveLower
        | KernelRoutine::SolveUpper
        | KernelRoutine::TrSolveLower
        | KernelRoutine::TrSolveUpper => {
            let other = operands[1].at;
            let mut b = Matrix::<R>::read(memory, other, size, kernel.dims[1] as usize);
            let checked = kernel.routine != KernelRoutine::CholeskySolve;
            let singular = checked && (0..size).any(|k| a.at(k, k) == R::ZERO);
            if singular {
                b.fill(R::NAN);
            } else {
                triangular(kernel.routine, &a, &mut b);
            }
            b.write(memory, other);
            if checked {
                memory[out] = u64::from(!singular);
            }
        }
    }
}

/// Eliminates in nalgebra's order, which skips a column without a pivot. Returns the exchanged rows.
fn eliminate<R: Real>(a: &mut Matrix<R>) -> Vec<(usize, usize)> {
    let size = a.rows;
    let mut exchanged = Vec::new();
    for k in 0..size {
        let magnitude = |row: usize| {
            let value = a.at(row, k);
            if value < R::ZERO { -value } else { value }
        };
        let mut pivot = k;
        for row in k + 1..size {
            if magnitude(row) > magnitude(pivot) {
                pivot = row;
            }
        }
        let diagonal = a.at(pivot, k);
        if diagonal == R::ZERO {
            continue;
        }
        if pivot != k {
            exchanged.push((k, pivot));
            a.swap_rows(k, pivot);
        }
        let reciprocal = R::ONE / diagonal;
        for row in k + 1..size {
            a.set(row, k, a.at(row, k) * reciprocal);
        }
        for col in k + 1..size {
            let factor = -a.at(k, col);
            for row in k + 1..size {
                a.set(row, col, factor * a.at(row, k) + a.at(row, col));
            }
        }
    }
    exchanged
}

/// Replaces `a` by its factors and `b` by the solution; returns false if `a` is singular.
fn solve<R: Real>(a: &mut Matrix<R>, b: &mut Matrix<R>) -> bool {
    let size = a.rows;
    for (one, other) in eliminate(a) {
        b.swap_rows(one, other);
    }
    if (0..size).any(|k| a.at(k, k) == R::ZERO) {
        return false;
    }
    for col in 0..b.cols() {
        for k in 0..size {
            let factor = -b.at(k, col);
            for row in k + 1..size {
                b.set(row, col, factor * a.at(row, k) + b.at(row, col));
            }
        }
        for k in (0..size).rev() {
            let value = b.at(k, col) / a.at(k, k);
            b.set(k, col, value);
            for row in 0..k {
                b.set(row, col, -value * a.at(row, k) + b.at(row, col));
            }
        }
    }
    true
}

fn inverse<R: Real>(mut a: Matrix<R>) -> Option<Matrix<R>> {
    let size = a.rows;
    if size > 4 {
        let mut out = Matrix::identity(size);
        return solve(&mut a, &mut out).then_some(out);
    }
    let m = |row: usize, col: usize| a.at(row - 1, col - 1);
    // What is left of a 2×2 block: `a b - c d`.
    let block = |a: R, b: R, c: R, d: R| a * b - c * d;
    let elements = match size {
        1 => {
            let inverse = (m(1, 1) != R::ZERO).then(|| vec![R::ONE / m(1, 1)]);
            return inverse.map(|elements| Matrix { rows: 1, elements });
        }
        4 => return inverse_of_four(&a),
        2 => [m(2, 2), -m(2, 1), -m(1, 2), m(1, 1)].to_vec(),
        _ => [
            block(m(2, 2), m(3, 3), m(3, 2), m(2, 3)),
            -block(m(2, 1), m(3, 3), m(3, 1), m(2, 3)),
            block(m(2, 1), m(3, 2), m(3, 1), m(2, 2)),
            block(m(1, 3), m(3, 2), m(3, 3), m(1, 2)),
            block(m(1, 1), m(3, 3), m(3, 1), m(1, 3)),
            block(m(1, 2), m(3, 1), m(3, 2), m(1, 1)),
            block(m(1, 2), m(2, 3), m(2, 2), m(1, 3)),
            block(m(1, 3), m(2, 1), m(2, 3), m(1, 1)),
            block(m(1, 1), m(2, 2), m(2, 1), m(1, 2)),
        ]
        .to_vec(),
    };
    let determinant = determinant(a);
    let divided = elements.into_iter().map(|element| element / determinant).collect();
    (determinant != R::ZERO).then_some(Matrix { rows: size, elements: divided })
}

fn inverse_of_four<R: Real>(a: &Matrix<R>) -> Option<Matrix<R>> {
    let m = &a.elements;
    let cofactor = |products: &Products| {
        let signed = products.iter().map(|&(sign, [x, y, z])| {
            let first = if sign < 0 { -m[x] } else { m[x] };
            first * m[y] * m[z]
        });
        // A negative product added is the product taken away.
        signed.reduce(|sum, product| sum + product).unwrap_or(R::ZERO)
    };
    let mut out = a.clone();
    for (element, products) in &COFACTORS {
        out.elements[*element] = cofactor(products);
    }
    let first = |k: usize| m[k] * out.elements[4 * k];
    let determinant = first(0) + first(1) + first(2) + first(3);
    let reciprocal = R::ONE / determinant;
    out.elements.iter_mut().for_each(|element| *element = *element * reciprocal);
    (determinant != R::ZERO).then_some(out)
}

/// Replaces the lower triangle by the factor L, or by NaN if there is none.
fn cholesky<R: Real>(a: &mut Matrix<R>) -> bool {
    let size = a.rows;
    for col in 0..size {
        for k in 0..col {
            let factor = -a.at(col, k);
            for row in col..size {
                a.set(row, col, factor * a.at(row, k) + a.at(row, col));
            }
        }
        let square = a.at(col, col);
        if square > R::ZERO {
            let root = square.root();
            a.set(col, col, root);
            for row in col + 1..size {
                a.set(row, col, a.at(row, col) / root);
            }
            continue;
        }
        for col in 0..size {
            (col..size).for_each(|row| a.set(row, col, R::NAN));
        }
        return false;
    }
    true
}

/// Solves with a triangle of `a`, dividing by its diagonal.
fn triangular<R: Real>(routine: KernelRoutine, a: &Matrix<R>, b: &mut Matrix<R>) {
    let size = a.rows;
    for col in 0..b.cols() {
        if matches!(routine, KernelRoutine::SolveLower | KernelRoutine::CholeskySolve) {
            (0..size).for_each(|k| take(a, b, col, k, k + 1..size));
        }
        if routine == KernelRoutine::SolveUpper {
            (0..size).rev().for_each(|k| take(a, b, col, k, 0..k));
        }
        if matches!(routine, KernelRoutine::TrSolveLower | KernelRoutine::CholeskySolve) {
            (0..size).rev().for_each(|k| gather(a, b, col, k, k + 1..size));
        }
        if routine == KernelRoutine::TrSolveUpper {
            (0..size).for_each(|k| gather(a, b, col, k, 0..k));
        }
    }
}

/// Divides value `k` of a column, and subtracts it from the rows that are still unknown.
fn take<R: Real>(
    a: &Matrix<R>,
    b: &mut Matrix<R>,
    col: usize,
    k: usize,
    open: core::ops::Range<usize>,
) {
    let value = b.at(k, col) / a.at(k, k);
    b.set(k, col, value);
    for row in open {
        b.set(row, col, -value * a.at(row, k) + b.at(row, col));
    }
}

/// Subtracts the scalar product with the known values from value `k`, and divides it.
fn gather<R: Real>(
    a: &Matrix<R>,
    b: &mut Matrix<R>,
    col: usize,
    k: usize,
    known: core::ops::Range<usize>,
) {
    let term = |row: usize| a.at(row, k) * b.at(row, col);
    let product = lanes(known.len(), |index| term(known.start + index));
    b.set(k, col, (b.at(k, col) - product) / a.at(k, k));
}

fn determinant<R: Real>(mut a: Matrix<R>) -> R {
    let size = a.rows;
    if size <= 3 {
        let m = |row: usize, col: usize| a.at(row - 1, col - 1);
        return match size {
            1 => m(1, 1),
            2 => m(1, 1) * m(2, 2) - m(2, 1) * m(1, 2),
            _ => {
                let minor =
                    |col: usize, other: usize| m(2, col) * m(3, other) - m(3, col) * m(2, other);
                m(1, 1) * minor(2, 3) - m(1, 2) * minor(1, 3) + m(1, 3) * minor(1, 2)
            }
        };
    }
    let odd = !eliminate(&mut a).len().is_multiple_of(2);
    let product = (0..size).fold(R::ONE, |product, k| product * a.at(k, k));
    if odd { -product } else { product }
}
