//! The computation of the thesis' Chapter 6. nalgebra's own LU ends at 127 rows, so the solve is an elimination in
//! nalgebra's order, by columns, in place.

use nalgebra::{SMatrix, SVector};

use crate::{Case, Element, Numbers, Prepared};

/// The solution `x = A\b` with 200 by 200 elements.
struct Solve {
    numbers: Numbers<f64>,
    a: Box<SMatrix<f64, 200, 200>>,
    x: SVector<f64, 200>,
}

impl Prepared for Solve {
    fn load(&mut self) {
        self.a.copy_from_slice(&self.numbers.matrix);
        self.x.copy_from_slice(&self.numbers.vector);
    }
    fn destroys(&self) -> bool {
        true
    }
    fn run(&mut self) {
        solve(&mut self.a, &mut self.x);
    }
    fn words(&self) -> Vec<u64> {
        self.x.iter().map(|number| number.word()).collect()
    }
}

/// The inverse of a matrix of 100 by 100 elements.
struct Invert {
    numbers: Numbers<f64>,
    a: Box<SMatrix<f64, 100, 100>>,
}

impl Prepared for Invert {
    fn load(&mut self) {
        self.a.copy_from_slice(&self.numbers.matrix);
    }
    fn destroys(&self) -> bool {
        true
    }
    fn run(&mut self) {
        self.a.try_inverse_mut();
    }
    fn words(&self) -> Vec<u64> {
        self.a.iter().map(|number| number.word()).collect()
    }
}

/// Elimination with row pivoting, in nalgebra's order for each element.
#[inline(never)]
fn solve<const N: usize>(a: &mut SMatrix<f64, N, N>, b: &mut SVector<f64, N>) -> bool {
    for k in 0..N {
        let pivot = k + a.view_range(k.., k).icamax();
        if a[(pivot, k)] == 0.0 {
            return false;
        }
        a.swap_rows(k, pivot);
        b.swap_rows(k, pivot);
        let reciprocal = 1.0 / a[(k, k)];
        let (mut left, mut right) = a.columns_range_pair_mut(k, k + 1..);
        let mut multipliers = left.rows_range_mut(k + 1..);
        multipliers *= reciprocal;
        for mut column in right.column_iter_mut() {
            let factor = -column[k];
            column.rows_range_mut(k + 1..).axpy(factor, &multipliers, 1.0);
        }
        let factor = -b[k];
        b.rows_range_mut(k + 1..).axpy(factor, &multipliers, 1.0);
    }
    a.solve_upper_triangular_mut(b)
}

/// Returns both parts of the computation.
pub fn cases() -> Vec<Case> {
    vec![
        Case {
            name: "lu_solve_f64_200".into(),
            prepare: Box::new(|| {
                let numbers = Numbers::new(200);
                Box::new(Solve { numbers, a: zeros(), x: SVector::zeros() })
            }),
        },
        Case {
            name: "inverse_f64_100".into(),
            prepare: Box::new(|| Box::new(Invert { numbers: Numbers::new(100), a: zeros() })),
        },
    ]
}

fn zeros<const N: usize>() -> Box<SMatrix<f64, N, N>> {
    Box::new(SMatrix::zeros())
}
