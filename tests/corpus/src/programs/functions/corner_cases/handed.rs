//! Closures as arguments: for methods, with structs and arrays, several at once, and names with another meaning
//! inside.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Table {
    pub values: [i16; 4],
    pub offset: i16,
}

#[data]
impl Table {
    /// The sum of the results of a closure for each value.
    pub fn total(&self, each: impl Fn(i16, usize) -> i16) -> i16 {
        let mut sum = self.offset;
        for (i, value) in self.values.iter().enumerate() {
            sum = sum.wrapping_add(each(*value, i));
        }
        sum
    }

    /// Changes each value in place.
    pub fn change<F>(&mut self, mut each: F)
    where
        F: FnMut(&mut i16),
    {
        for value in &mut self.values {
            each(value);
        }
    }
}

/// A closure that captures variables with the names of the method's own.
#[function]
pub fn shadowing(table: &Table, sum: i16, i: usize) -> i16 {
    table.total(|value, at| if at == i { value.wrapping_add(sum) } else { value })
}

/// Two different closures for the same method.
#[function]
pub fn twice(table: &Table) -> i16 {
    let double = |value: i16, _at: usize| value.wrapping_mul(2);
    let negated = |value: i16, _at: usize| value.wrapping_neg();
    table.total(double).wrapping_sub(table.total(negated))
}

/// A closure that writes to a captured variable and to its argument.
#[function]
pub fn changed(table: &Table, limit: i16) -> (Table, u32) {
    let mut copy = *table;
    let mut clipped = 0;
    copy.change(|value| {
        if *value > limit {
            *value = limit;
            clipped += 1;
        }
    });
    (copy, clipped)
}

/// Two closures, one of which is passed on.
#[function]
fn composed<T: Real>(x: T, f: impl Fn(T) -> T, g: impl Fn(T) -> T) -> T {
    repeated(g(x), f)
}

#[function]
fn repeated<T: Real>(mut x: T, f: impl Fn(T) -> T) -> T {
    for _ in 0..3 {
        x = f(x);
    }
    x
}

/// Calls it in single and in double precision.
#[function]
pub fn both(x: f32, y: f64, table: [f64; 2]) -> (f32, f64) {
    let single = composed(x, |x| x * 0.5, |x| x - 1.0);
    let double = composed(y, |y| y * table[0], |y| y + table[1]);
    (single, double)
}

/// A closure that can fault, in a function that can fault.
#[function]
pub fn faulting(count: u8, parts: [u8; 3]) -> u8 {
    repeated_u8(count, |at| parts[usize::from(at)] + 1)
}

#[function]
fn repeated_u8(count: u8, f: impl Fn(u8) -> u8) -> u8 {
    let mut value = count;
    for _ in 0..2 {
        value = f(value) / 2 + f(1);
    }
    value - 1
}

/// An author's function that a closure calls.
#[function]
fn squared(x: i16) -> i16 {
    x.wrapping_mul(x)
}

/// The sum of its results for the elements.
#[function]
pub fn called(table: &Table, by: i16) -> i16 {
    table.total(|value, _| squared(value.wrapping_sub(by)))
}
