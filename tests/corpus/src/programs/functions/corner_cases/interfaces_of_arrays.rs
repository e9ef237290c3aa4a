//! Interfaces that arrays and tuples of Rust implement, and generic functions that call them by a bound of another crate.

use bessemer::prelude::*;
use num_traits::Float;

/// A vector of three numbers.
pub type Vector<T> = [T; 3];

/// A number and a vector.
pub type Pair<T> = (T, Vector<T>);

/// Operations that a vector and a pair have in common.
#[interface]
pub trait Ops<T>: Copy {
    /// The sum of the parts.
    fn sum(self) -> T;
    /// The product with a number.
    fn scale(self, s: T) -> Self;
    /// The length.
    fn norm(&self) -> T;
    /// The product of two values, part by part.
    fn product(self, other: Self) -> Self;
    /// The parts divided by their sum.
    fn shares(self) -> Self;
    /// Adds another value.
    fn add(&mut self, other: Self);
    /// The number of parts.
    fn parts(&self) -> u32 {
        3
    }
}

#[data]
impl<T: Float> Ops<T> for Vector<T> {
    fn sum(self) -> T {
        self.iter().skip(1).fold(self[0], |sum, part| sum + *part)
    }

    fn scale(self, s: T) -> Vector<T> {
        [s * self[0], s * self[1], s * self[2]]
    }

    fn norm(&self) -> T {
        let mut squares = T::zero();
        for part in self.iter() {
            squares = squares + *part * *part;
        }
        squares.sqrt()
    }

    fn product(self, other: Vector<T>) -> Vector<T> {
        [self[0] * other[0], self[1] * other[1], self[2] * other[2]]
    }

    fn shares(self) -> Self {
        self.scale(self.sum().recip())
    }

    fn add(&mut self, other: Vector<T>) {
        for (part, other) in self.iter_mut().zip(other.iter()) {
            *part = *part + *other;
        }
    }
}

#[data]
impl<T: Float> Ops<T> for (T, [T; 3]) {
    fn sum(self) -> T {
        self.0 + self.1.sum()
    }

    fn scale(self, s: T) -> Pair<T> {
        (s * self.0, self.1.scale(s))
    }

    fn norm(&self) -> T {
        self.0.hypot(self.1.norm())
    }

    fn product(self, other: Pair<T>) -> Pair<T> {
        (self.0 * other.0, self.1.product(other.1))
    }

    fn shares(self) -> Self {
        self.scale(self.sum().recip())
    }

    fn add(&mut self, other: Pair<T>) {
        self.0 = self.0 + other.0;
        self.1.add(other.1);
    }

    fn parts(&self) -> u32 {
        1 + self.1.parts()
    }
}

#[data]
impl Ops<i32> for [i32; 2] {
    fn sum(self) -> i32 {
        self[0].wrapping_add(self[1])
    }

    fn scale(self, s: i32) -> Self {
        [self[0].wrapping_mul(s), self[1].wrapping_mul(s)]
    }

    fn norm(&self) -> i32 {
        self[0].wrapping_abs().wrapping_add(self[1].wrapping_abs())
    }

    fn product(self, other: Self) -> Self {
        [self[0].wrapping_mul(other[0]), self[1].wrapping_mul(other[1])]
    }

    fn shares(self) -> Self {
        self
    }

    fn add(&mut self, other: Self) {
        self[0] = self[0].wrapping_add(other[0]);
        self[1] = self[1].wrapping_sub(other[1]);
    }
}

/// The product with a number, of whatever has one.
#[function]
pub fn scale<T, Q>(s: T, q: Q) -> Q
where
    T: Float,
    Q: Ops<T>,
{
    q.scale(s)
}

/// The length of whatever has one.
#[function]
pub fn norm<T: Float, Q: Ops<T>>(q: Q) -> T {
    q.norm()
}

/// A generic function that calls the others with an array and with a tuple.
#[function]
fn measured<T: Float>(s: T, q: Pair<T>) -> T {
    norm(scale(s, q)) + norm(q.1) + scale(s, q.1)[1] + q.shares().0 + T::from(q.parts()).unwrap_or(s)
}

/// In double precision.
#[function]
pub fn in_double(s: f64, first: f64, rest: [f64; 3]) -> f64 {
    let mut twice = (first, rest);
    twice.add((s, rest));
    twice.1.add([s, first, s]);
    twice.sum() + measured(s, (first, rest)) + rest.product(rest.shares()).sum() + f64::from(rest.parts())
}

/// In single precision.
#[function]
pub fn in_single(s: f32, first: f32, rest: [f32; 3]) -> f32 {
    measured(s, (first, rest)) + rest.product(rest.shares()).sum()
}

/// The operations on integers.
#[function]
pub fn of_integers(s: i32, values: [i32; 2]) -> i32 {
    values.product(values.shares()).scale(s).sum().wrapping_add(values.norm()).wrapping_add(values.parts() as i32)
}
