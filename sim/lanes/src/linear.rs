//! Linear algebra in nalgebra's order of operations. Matrices are arrays, column by column.

use std::array::from_fn;

use crate::Real;

macro_rules! elementwise {
    ($($(#[$doc:meta])* $name:ident $op:tt),*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub fn $name<const N: usize>(a: &[Real; N], b: &[Real; N]) -> [Real; N] {
            from_fn(|n| a[n] $op b[n])
        }
    )*};
}

elementwise! {
    /// Adds element by element.
    add +,
    /// Subtracts element by element.
    sub -,
    /// Multiplies element by element.
    component_mul *,
    /// Divides element by element.
    component_div /
}

/// Returns the negative of each element.
#[inline(always)]
pub fn neg<const N: usize>(a: &[Real; N]) -> [Real; N] {
    a.map(|value| -value)
}

/// Multiplies each element by a number.
#[inline(always)]
pub fn scale<const N: usize>(a: &[Real; N], by: Real) -> [Real; N] {
    a.map(|value| value * by)
}

/// Divides each element by a number.
#[inline(always)]
pub fn unscale<const N: usize>(a: &[Real; N], by: Real) -> [Real; N] {
    a.map(|value| value / by)
}

/// Returns the transpose of a matrix with R rows.
#[inline(always)]
pub fn transpose<const R: usize, const N: usize>(a: &[Real; N]) -> [Real; N] {
    let columns = N / R;
    from_fn(|n| a[n / columns + n % columns * R])
}

/// Returns the product of a matrix with R rows and K columns, and one with K rows. Each sum begins with its first term.
#[inline(always)]
pub fn product<const R: usize, const K: usize, const A: usize, const B: usize, const N: usize>(
    a: &[Real; A],
    b: &[Real; B],
) -> [Real; N] {
    from_fn(|n| {
        let (row, column) = (n % R, n / R);
        let term = |k: usize| a[row + k * R] * b[k + column * K];
        (1..K).fold(term(0), |sum, k| term(k) + sum)
    })
}

/// Returns the product of a transposed matrix, with K rows and R columns, and one with K rows, in the order of
/// [`product`].
#[inline(always)]
pub fn tr_product<
    const R: usize,
    const K: usize,
    const A: usize,
    const B: usize,
    const N: usize,
>(
    a: &[Real; A],
    b: &[Real; B],
) -> [Real; N] {
    from_fn(|n| {
        let (row, column) = (n % R, n / R);
        let term = |k: usize| a[k + row * K] * b[k + column * K];
        (1..K).fold(term(0), |sum, k| term(k) + sum)
    })
}

/// Returns the scalar product of two matrices with R rows. Columns of 2, 3 and 4 elements have orders of their own; others have
/// eight partial sums along each column.
#[inline(always)]
pub fn dot<const R: usize, const N: usize>(a: &[Real; N], b: &[Real; N]) -> Real {
    let term = |n: usize| a[n] * b[n];
    match (R, N / R) {
        (2, 1) => return term(0) + term(1),
        (3, 1) => return (term(0) + term(1)) + term(2),
        (4, 1) => return (term(0) + term(2)) + (term(1) + term(3)),
        _ => {}
    }
    (0..N / R).fold(Real::of(0.0), |sum, column| summed(sum, R, |row| term(column * R + row)))
}

/// Adds terms to a sum, in eight partial sums.
#[inline(always)]
fn summed(mut sum: Real, count: usize, term: impl Fn(usize) -> Real) -> Real {
    let mut parts = [Real::of(0.0); 8];
    let blocks = count / 8;
    for block in 0..blocks {
        for (n, part) in parts.iter_mut().enumerate() {
            *part = *part + term(block * 8 + n);
        }
    }
    for n in 0..4 {
        sum = sum + (parts[n] + parts[n + 4]);
    }
    for n in blocks * 8..count {
        sum = sum + term(n);
    }
    sum
}

/// Returns the sum of the squares of a matrix with R rows, column by column.
#[inline(always)]
pub fn norm_squared<const R: usize, const N: usize>(a: &[Real; N]) -> Real {
    (0..N / R).fold(Real::of(0.0), |sum, column| {
        let values: [Real; R] = from_fn(|row| a[column * R + row]);
        sum + dot::<R, R>(&values, &values)
    })
}

/// Returns the root of the sum of the squares of a matrix with R rows.
#[inline(always)]
pub fn norm<const R: usize, const N: usize>(a: &[Real; N]) -> Real {
    norm_squared::<R, N>(a).sqrt()
}

/// Returns the cross product.
#[inline(always)]
pub fn cross(a: &[Real; 3], b: &[Real; 3]) -> [Real; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Returns the product of a transposed matrix with R rows and another one with R rows. As in nalgebra's `tr_mul`, each element is a
/// scalar product of columns.
#[inline(always)]
pub fn tr_mul<const R: usize, const A: usize, const B: usize, const N: usize>(
    a: &[Real; A],
    b: &[Real; B],
) -> [Real; N] {
    let columns = A / R;
    from_fn(|n| {
        let (row, column) = (n % columns, n / columns);
        let one: [Real; R] = from_fn(|k| a[row * R + k]);
        let other: [Real; R] = from_fn(|k| b[column * R + k]);
        dot::<R, R>(&one, &other)
    })
}
