//! Operands that write to the other operand: the left one is evaluated first, and each once.

use bessemer::prelude::*;

/// Changes a number and returns it.
#[function]
fn stepped(x: &mut f64) -> f64 {
    *x = *x * 0.5 + 1.0;
    *x
}

/// Changes a vector and returns one of its elements.
#[function]
fn turned(v: &mut Vector3<f64>) -> f64 {
    v[1] = v[0] + 0.5;
    v[0] = -v[2];
    v[1]
}

/// Increments a count and returns it.
#[function]
fn next(count: &mut usize) -> usize {
    *count += 1;
    *count
}

/// The right side of `+=` writes to the left side.
#[function]
pub fn added_to_what_it_writes(mut x: f64) -> f64 {
    x += stepped(&mut x);
    x
}

/// The right side of `-=` writes to the vector whose element is the left side.
#[function]
pub fn taken_from_an_element_that_it_writes(mut v: Vector3<f64>) -> Vector3<f64> {
    v[0] -= turned(&mut v);
    v
}

/// A factor that writes to the vector on its right.
#[function]
pub fn times_the_vector_that_it_writes(mut v: Vector3<f64>) -> Vector3<f64> {
    turned(&mut v) * v
}

/// Elements of a matrix in rows; each changes the variable that the next one reads.
#[function]
pub fn elements_by_rows(mut x: f64) -> Matrix2<f64> {
    Matrix2::new(x, stepped(&mut x), x, stepped(&mut x))
}

/// The index of a compound assignment is evaluated once.
#[function]
pub fn counted_once(mut values: [f64; 4], count: u8) -> [f64; 4] {
    let mut at = (count % 3) as usize;
    values[next(&mut at)] *= 2.0;
    values[at] += 0.25;
    values
}

/// The index in `take` of an option is evaluated once.
#[function]
pub fn taken_once(mut values: [Option<i16>; 4], count: &mut usize) -> [Option<i16>; 4] {
    *count %= 3;
    let taken = values[next(count)].take();
    values[0] = taken;
    values
}
