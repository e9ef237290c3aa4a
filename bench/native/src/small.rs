//! Cases of sizes 2 to 20, in the form of a model's code.

use std::hint::black_box;

use nalgebra::{SMatrix, SVector};

use crate::{Case, Element, Numbers, Prepared};

/// Function that a model calls.
type Call<T, const N: usize, R> =
    fn(&SMatrix<T, N, N>, &SMatrix<T, N, N>, &SVector<T, N>) -> Option<R>;

/// A routine on matrices of a fixed size.
struct Small<T, const N: usize, R> {
    a: SMatrix<T, N, N>,
    second: SMatrix<T, N, N>,
    b: SVector<T, N>,
    routine: Call<T, N, R>,
    result: Option<R>,
}

/// A result that can be converted to words.
trait Words {
    fn words(&self) -> Vec<u64>;
}

impl<T: Element, const R: usize, const C: usize> Words for SMatrix<T, R, C> {
    fn words(&self) -> Vec<u64> {
        self.iter().map(|number| number.word()).collect()
    }
}

impl<T: Element, const N: usize, R: Words> Prepared for Small<T, N, R> {
    fn load(&mut self) {}
    fn destroys(&self) -> bool {
        false
    }
    fn run(&mut self) {
        let routine = black_box(self.routine);
        self.result = routine(&self.a, &self.second, &self.b);
    }
    fn words(&self) -> Vec<u64> {
        self.result.as_ref().map(R::words).unwrap_or_default()
    }
}

fn case<T: Element, const N: usize, R: Words + 'static>(
    name: &str,
    definite: bool,
    routine: Call<T, N, R>,
) -> Case {
    Case {
        name: format!("{name}_{}_{N}", T::NAME),
        prepare: Box::new(move || {
            let size = N as u16;
            let numbers = if definite { Numbers::definite(size) } else { Numbers::<T>::new(size) };
            Box::new(Small {
                a: SMatrix::from_column_slice(&numbers.matrix),
                second: SMatrix::from_column_slice(&numbers.second),
                b: SVector::from_column_slice(&numbers.vector),
                routine,
                result: None,
            })
        }),
    }
}

/// Returns all cases of one float type.
pub fn cases<T: Element>() -> Vec<Case> {
    let mut cases = Vec::new();
    macro_rules! sizes {
        ($($n:literal)*) => {$(
            cases.push(case::<T, $n, SVector<T, $n>>("lu_solve", false, |a, _, b| a.lu().solve(b)));
            cases.push(case::<T, $n, SMatrix<T, $n, $n>>("inverse", false, |a, _, _| a.try_inverse()));
            cases.push(case::<T, $n, SVector<T, $n>>("cholesky_solve", true, |a, _, b| {
                a.cholesky().map(|factors| factors.solve(b))
            }));
            cases.push(case::<T, $n, SMatrix<T, $n, $n>>("product", false, |a, second, _| Some(a * second)));
        )*};
    }
    sizes!(2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20);
    cases
}
