//! References to an `Option`'s content: the place that they refer to, order of evaluation, and copies.

use bessemer::prelude::*;

/// Counts steps.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Counter {
    /// Steps so far.
    pub steps: u8,
    /// Last reading.
    pub last: Option<i16>,
}

#[data]
impl Counter {
    /// Increments the steps; returns their number.
    pub fn step(&mut self, by: u8) -> u8 {
        self.steps += by;
        self.steps
    }

    /// An author's method with the name of one of `Option`'s.
    pub fn insert(&mut self, by: u8) -> u8 {
        self.steps = by;
        100
    }

    /// An author's method with the name of one of `Option`'s.
    pub fn get_or_insert(&self, by: u8) -> u8 {
        self.steps.wrapping_add(by)
    }

    /// An author's method with the name of one of `Option`'s.
    pub fn as_mut(&mut self) -> Option<u8> {
        if self.steps > 3 { Some(self.steps) } else { None }
    }

    /// An author's method with the name of one of `Option`'s.
    pub fn xor(&self, other: Counter) -> u8 {
        self.steps ^ other.steps
    }

    /// An author's method with the name of one of `Option`'s.
    pub fn get_or_insert_with(&self, by: u8) -> u8 {
        by
    }
}

/// Calls of the author's methods are not taken for those of `Option`.
#[function]
pub fn own(counter: &mut Counter, by: u8) -> u8 {
    let a = counter.insert(by);
    let b = counter.get_or_insert(1);
    let c = counter.as_mut().unwrap_or(7);
    let d = counter.xor(*counter);
    let e = counter.get_or_insert_with(9);
    a.wrapping_add(b).wrapping_add(c).wrapping_add(d).wrapping_add(e)
}

/// Such calls in a function that returns an `Option`.
#[function]
pub fn own_or_none(counter: &mut Counter) -> Option<u8> {
    let steps = counter.as_mut()?;
    Some(steps - 1)
}

/// A method of the content changes it in place.
#[function]
pub fn methods(counter: &mut Option<Counter>, by: u8) -> u8 {
    let first = counter.get_or_insert(Counter { steps: 3, last: None }).step(by);
    let second = counter.as_mut().unwrap().step(1);
    let third = counter.as_mut().map_or(0, |counter| counter.step(2));
    let fourth = counter.insert(Counter::default()).step(by);
    first.wrapping_add(second).wrapping_add(third).wrapping_add(fourth)
}

/// A named reference to the content, and a fault if there is none.
#[function]
pub fn named(counter: &mut Option<Counter>, by: u8) -> u8 {
    let lent = counter.as_mut().unwrap();
    lent.steps = by;
    lent.step(1);
    let last = lent.last.as_mut().expect("the last must be there");
    *last += 1;
    if *last > 3 {
        lent.last = None;
    }
    lent.steps
}

/// Returns `None` if there is no content.
#[function]
pub fn or_none(counter: &mut Option<Counter>) -> Option<u8> {
    let lent = counter.as_mut()?;
    lent.step(5);
    Some(lent.steps)
}

/// The argument is evaluated once, whether or not it is needed, and may fault.
#[function]
pub fn eager(kept: &mut Option<u8>, counter: &mut Counter, by: u8) -> u8 {
    let value = *kept.get_or_insert(counter.step(by));
    let other = *kept.insert(counter.step(1));
    kept.get_or_insert_with(|| counter.step(100));
    value.wrapping_add(other)
}

/// The closure is called only if there is no content.
#[function]
pub fn lazy(kept: &mut Option<u8>, counter: &mut Counter, by: u8) -> u8 {
    let value = *kept.get_or_insert_with(|| counter.step(by));
    value.wrapping_add(counter.steps)
}

/// An element: first its index is checked, then the argument is evaluated.
#[function]
pub fn indexed(kept: &mut [Option<u8>; 3], at: usize, divisor: u8) -> u8 {
    let mut i = at;
    let _ = kept[i].insert(10 / divisor);
    i += 1;
    *kept[i].get_or_insert({
        i = 0;
        20 / divisor
    }) += 1;
    if let Some(first) = kept[i].as_mut() {
        i = 2;
        *first += 1;
    }
    kept[i].get_or_insert(7).wrapping_add(at as u8)
}

/// References to optional elements of a list.
#[function]
pub fn listed(kept: &mut List<Option<u8>, 3>, at: usize) -> u8 {
    *kept[at].get_or_insert(5) += 1;
    let _ = kept[at].insert(9);
    match kept[0].as_mut() {
        Some(x) if *x > 3 => {
            *x -= 3;
            *x
        }
        Some(x) => *x,
        None => 0,
    }
}

/// Method calls in a row, whose result is discarded.
#[function]
pub fn thrown(kept: &mut Option<i32>, x: i32) -> i32 {
    let _ = kept.insert(x);
    kept.get_or_insert(3);
    let y = kept.as_mut().map(|kept| {
        *kept = kept.wrapping_add(1);
        *kept
    });
    let is = kept.as_mut().is_some_and(|kept| *kept > 3);
    y.unwrap_or(0).wrapping_add(is as i32)
}

/// `xor` of two options.
#[function]
pub fn either(a: Option<u8>, b: Option<u8>, counter: &mut Counter) -> Option<u8> {
    let one = a.xor(b);
    let other = Some(counter.step(1)).xor(if counter.steps > 3 { a } else { None });
    one.xor(other).xor(None)
}

/// `mem::take` leaves the default: of a number, a list, an array, and an author's struct.
#[function]
pub fn taken(x: &mut u8, list: &mut List<u8, 3>, array: &mut [f64; 2], counter: &mut Counter) -> f64 {
    let a = core::mem::take(x);
    let b = core::mem::take(list);
    let c = core::mem::take(array);
    let mut d = core::mem::take(counter);
    d.step(a);
    counter.last = core::mem::take(&mut d.last);
    let e = core::mem::take(&mut array[1]);
    f64::from(a) + b.len() as f64 + c[0] + e + f64::from(d.steps)
}

/// References to generic content.
#[function]
pub fn held<T: Real>(held: &mut Option<T>, x: T) -> T {
    *held.get_or_insert(x) += x;
    match held.as_mut() {
        Some(held) => {
            *held *= x;
            *held
        }
        None => x,
    }
}

/// Calls the generic function with two types.
#[function]
pub fn both(a: &mut Option<f32>, b: &mut Option<f64>, x: f32) -> f64 {
    held(b, f64::from(x)) + f64::from(held(a, x))
}
