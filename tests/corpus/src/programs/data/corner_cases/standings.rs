//! `Ordering`: of every kind of number, stored in structs and arrays, with side effects and faults.

use core::cmp::Ordering;

use bessemer::prelude::*;

/// Stores orderings.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kept {
    /// The last ordering.
    pub last: Option<Ordering>,
    /// Two orderings.
    pub all: [Ordering; 2],
    /// Number of elements.
    pub count: u8,
}

#[data]
impl Kept {
    /// An author's method with the name of one of numbers'.
    pub fn cmp(&self, other: &Kept) -> u8 {
        self.count.wrapping_add(other.count)
    }

    /// An author's method with the name of one of numbers'.
    pub fn partial_cmp(&self, other: u8) -> u8 {
        self.count.wrapping_mul(other)
    }

    /// An author's method with the name of one of `Ordering`'s.
    pub fn reverse(&mut self) -> u8 {
        self.count += 1;
        self.count
    }

    /// An author's method with the name of one of `Ordering`'s.
    pub fn then(&self, other: u8) -> u8 {
        other
    }

    /// An author's method with the name of one of `Ordering`'s.
    pub fn is_lt(&self) -> bool {
        self.count < 3
    }
}

/// Calls of the author's methods are not taken for those of numbers.
#[function]
pub fn own(kept: &mut Kept) -> u8 {
    let other = *kept;
    let a = kept.cmp(&other);
    let b = kept.partial_cmp(3);
    let c = kept.reverse();
    let d = kept.then(5);
    a.wrapping_add(b).wrapping_add(c).wrapping_add(d).wrapping_add(kept.is_lt() as u8)
}

/// Order of each kind of number.
#[function]
pub fn kinds(a: u8, b: u8, c: i64, d: i64, e: usize, f: bool, g: bool) -> [Ordering; 4] {
    [a.cmp(&b), c.cmp(&d), e.cmp(&3), f.cmp(&g)]
}

/// Ordering of floats, which may be `None`.
#[function]
pub fn floats(x: f64, y: f64, z: f32) -> (Option<Ordering>, Option<Ordering>, Ordering) {
    (x.partial_cmp(&y), z.partial_cmp(&0.5), x.total_cmp(&y))
}

/// Ordering of integers by `partial_cmp`, which is never `None`.
#[function]
pub fn partial(x: i8, y: i8) -> bool {
    x.partial_cmp(&y) == Some(Ordering::Less) || x.partial_cmp(&y).unwrap() == Ordering::Equal
}

/// Stores an ordering in a struct, and compares it.
#[function]
pub fn kept(kept: &mut Kept, x: u16, y: u16) -> bool {
    let order = x.cmp(&y);
    let same = kept.last == Some(order);
    kept.last = Some(order.reverse());
    kept.all[(x % 3) as usize] = order;
    kept.all[0] != kept.all[1] || same
}

/// Methods of an `Ordering`.
#[function]
pub fn asked(x: i32, y: i32) -> u8 {
    let order = x.cmp(&y);
    let mut bits = order.is_lt() as u8;
    bits |= (order.is_le() as u8) << 1;
    bits |= (order.is_gt() as u8) << 2;
    bits |= (order.is_ge() as u8) << 3;
    bits |= (order.is_eq() as u8) << 4;
    bits |= (order.is_ne() as u8) << 5;
    if x.cmp(&y).is_lt() && order != Ordering::Greater {
        bits |= 64;
    }
    bits
}

/// The number of an ordering.
#[function]
pub fn number(x: i32, y: i32) -> i8 {
    x.cmp(&y) as i8
}

/// Both operands are evaluated once, the left one first; `then` evaluates its argument, `then_with` only if needed.
#[function]
pub fn effects(kept: &mut Kept, x: u8, divisor: u8) -> Ordering {
    let one = kept.reverse().cmp(&(x / divisor));
    let other = one.then(kept.reverse().cmp(&3)).then_with(|| kept.reverse().cmp(&x));
    other.then_with(|| x.cmp(&(100 / divisor)))
}

/// A `match` with several orderings in an arm, a guard, and imported variants.
#[function]
pub fn matched(x: f32, y: f32) -> u8 {
    use core::cmp::Ordering::{Equal, Greater, Less};
    match x.partial_cmp(&y) {
        Some(Less | Equal) if y > 4.0 => 1,
        Some(Less) => 2,
        Some(Equal | Greater) => 3,
        None => 4,
    }
}

/// The greater of two numbers, by a function that is passed on.
#[function]
pub fn by<F: Fn(i32, i32) -> Ordering>(x: i32, y: i32, order: F) -> i32 {
    match order(x, y) {
        Ordering::Greater => x,
        _ => y,
    }
}

/// Calls it with different functions.
#[function]
pub fn handed(x: i32, y: i32, z: i32) -> i32 {
    by(x, y, |a, b| a.cmp(&b)).wrapping_add(by(x, y, |a, b| b.cmp(&a).then(z.cmp(&a))))
}

/// Order of generic numbers.
#[function]
pub fn between<T: Real>(x: T, low: T, high: T) -> Ordering {
    match (x.partial_cmp(&low), x.partial_cmp(&high)) {
        (Some(Ordering::Less), _) => Ordering::Less,
        (_, Some(Ordering::Greater)) => Ordering::Greater,
        _ => Ordering::Equal,
    }
}

/// Calls it with two types.
#[function]
pub fn generics(x: f32, y: f64) -> Ordering {
    between(x, 0.0, 1.0).then(between(y, -1.0, 1.0))
}

/// Sorted in descending order, and by a part.
#[function]
pub fn sorted(values: &[i32; 5], limit: i32) -> [i32; 5] {
    let mut values = *values;
    values.sort_by(|a, b| b.cmp(a).reverse().then(Ordering::Equal));
    values[1..].sort_unstable_by(|a, b| match (*a > limit).cmp(&(*b > limit)) {
        Ordering::Equal => b.cmp(a),
        other => other,
    });
    values
}

/// The maximum by a partial order.
#[function]
pub fn best(values: &[f64; 4]) -> Option<f64> {
    let most = values.iter().copied().max_by(|a, b| a.partial_cmp(b).unwrap());
    let least = values.iter().copied().min_by(|a, b| b.total_cmp(a).reverse());
    most.and_then(|most| least.map(|least| most - least))
}
