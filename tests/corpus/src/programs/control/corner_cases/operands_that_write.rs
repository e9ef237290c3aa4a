//! Operands that write what stands beside them: the one on the left is computed first, and each of them once.

use bessemer::prelude::*;

/// Changes a number, and gives it.
#[function]
fn stepped(x: &mut f64) -> f64 {
    *x = *x * 0.5 + 1.0;
    *x
}

/// Changes a vector, and gives one of its elements.
#[function]
fn turned(v: &mut Vector3<f64>) -> f64 {
    v[1] = v[0] + 0.5;
    v[0] = -v[2];
    v[1]
}

/// Counts.
#[function]
fn next(count: &mut usize) -> usize {
    *count += 1;
    *count
}

/// An operand of `+=` that writes what is added to.
#[function]
pub fn added_to_what_it_writes(mut x: f64) -> f64 {
    x += stepped(&mut x);
    x
}

/// An operand of `-=` that writes the vector whose element is meant.
#[function]
pub fn taken_from_an_element_that_it_writes(mut v: Vector3<f64>) -> Vector3<f64> {
    v[0] -= turned(&mut v);
    v
}

/// A factor that writes the vector behind it.
#[function]
pub fn times_the_vector_that_it_writes(mut v: Vector3<f64>) -> Vector3<f64> {
    turned(&mut v) * v
}

/// Elements that write the one after them, written in rows.
#[function]
pub fn elements_by_rows(mut x: f64) -> Matrix2<f64> {
    Matrix2::new(x, stepped(&mut x), x, stepped(&mut x))
}

/// An index that counts, of an element that is read and written.
#[function]
pub fn counted_once(mut values: [f64; 4], count: u8) -> [f64; 4] {
    let mut at = (count % 3) as usize;
    values[next(&mut at)] *= 2.0;
    values[at] += 0.25;
    values
}

/// An index that counts, of an option from which the value is taken.
#[function]
pub fn taken_once(mut values: [Option<i16>; 4], count: &mut usize) -> [Option<i16>; 4] {
    *count %= 3;
    let taken = values[next(count)].take();
    values[0] = taken;
    values
}
