//! Authors' own iterators in every position: zipped, advanced by `next`, in a struct, under a name, and as an
//! argument.

use bessemer::prelude::*;

/// The steps of a ramp: each changes by at most the slope, and the last is the goal.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Ramp {
    at: i32,
    goal: i32,
    slope: i32,
}

#[data]
impl Ramp {
    /// A ramp from one value to another.
    pub fn new(from: i32, to: i32, slope: i32) -> Ramp {
        Ramp { at: from, goal: to, slope: slope.saturating_abs().max(1) }
    }
}

#[data]
impl Iterator for Ramp {
    type Item = i32;

    fn next(&mut self) -> Option<Self::Item> {
        if self.at == self.goal {
            return None;
        }
        let left = self.goal.saturating_sub(self.at);
        self.at = if left.saturating_abs() <= self.slope {
            self.goal
        } else {
            self.at.saturating_add(if left < 0 { -self.slope } else { self.slope })
        };
        Some(self.at)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (0, None)
    }
}

/// Largest number of steps of a ramp.
pub const LIMIT: usize = 12;

/// Length and sum of a ramp.
#[function]
pub fn through(from: i32, to: i32) -> (u32, i32) {
    let (mut steps, mut sum) = (0, 0_i32);
    #[bound(LIMIT)]
    for value in Ramp::new(from, to, 1000) {
        steps += 1;
        if value == 7 {
            continue;
        }
        sum = sum.wrapping_add(value);
        if sum > 100_000 {
            break;
        }
    }
    (steps, sum)
}

/// The sum of the first `n` steps.
#[function]
pub fn taken(from: i32, to: i32, n: usize) -> i32 {
    Ramp::new(from, to, 10).take(n & 7).map(|x| x.wrapping_mul(3)).filter(|x| x % 2 == 0).fold(0, |sum, x| sum ^ x)
}

/// The ramp zipped with elements, as the second and as the first part.
#[function]
pub fn beside(values: &[i32; 5], to: i32) -> (i32, i32) {
    let mut first = 0_i32;
    for (value, step) in values.iter().zip(Ramp::new(0, to, 3)) {
        first = first.wrapping_add(value.wrapping_mul(step));
    }
    let mut second = 0_i32;
    for (step, value) in Ramp::new(to, 0, 3).take(5).zip(values) {
        second = second.wrapping_sub(value.wrapping_mul(step));
    }
    (first, second)
}

/// The rest of a ramp after `next` calls.
#[function]
pub fn by_hand(to: i32) -> (Option<i32>, u32, Option<i32>, i32) {
    let mut ramp = Ramp::new(0, to, 2);
    let first = ramp.next();
    let mut even = 0;
    for (i, x) in ramp.by_ref().take(3).enumerate() {
        if x % 4 == 0 {
            even += i as u32;
        }
    }
    let third = ramp.clone().nth(1);
    (first, even, third, ramp.at)
}

/// The sum of the items of any iterator.
#[function]
pub fn summed(items: impl Iterator<Item = i32>) -> i32 {
    let mut sum = 0_i32;
    for item in items.take(4) {
        sum = sum.wrapping_add(item);
    }
    sum
}

/// A struct with an iterator as a field.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Mover {
    ramp: Ramp,
    moved: u32,
}

#[data]
impl Mover {
    /// Moves by a few steps; returns the position.
    pub fn advance(&mut self, steps: usize) -> i32 {
        let mut last = self.ramp.at;
        for value in self.ramp.by_ref().take(steps & 3) {
            last = value;
            self.moved = self.moved.saturating_add(1);
        }
        last
    }

    /// The next step of the ramp in its field.
    pub fn step(&mut self) -> Option<i32> {
        let ramp = &mut self.ramp;
        let next = ramp.next()?;
        self.moved = self.moved.saturating_add(1);
        Some(next)
    }
}

/// Passes the ramp to a function, by reference and by value.
#[function]
pub fn given(to: i32) -> [i32; 3] {
    let mut ramp = Ramp::new(0, to, 5);
    let first = summed(&mut ramp);
    let at = ramp.at;
    [first, at, summed(ramp)]
}

/// Passes the ramp to a loop by reference, and then takes the next step.
#[function]
pub fn lent(to: i32) -> (i32, Option<i32>) {
    let mut ramp = Ramp::new(0, to & 15, 5);
    let mut sum = 0_i32;
    #[bound(3)]
    for x in &mut ramp {
        sum = sum.wrapping_add(x);
    }
    ramp.goal = 20;
    (sum, Ramp::next(&mut ramp))
}

/// A ramp with a name before its loop.
#[function]
pub fn held(to: i32) -> i32 {
    let ramp = Ramp::new(1, to, 4);
    let odd = ramp.take(6).filter(|x| x % 2 != 0);
    let mut product = 1_i32;
    for x in odd {
        product = product.wrapping_mul(x);
    }
    product
}

/// Iterator over the fields of a line of text.
#[data]
#[derive(Clone, Debug)]
pub struct Fields<'a> {
    rest: &'a [u8],
}

#[data]
impl<'a> Iterator for Fields<'a> {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        let (first, rest) = self.rest.split_first()?;
        let mut number = u32::from(*first);
        self.rest = rest;
        while let [digit, rest @ ..] = self.rest {
            self.rest = rest;
            if *digit == b',' {
                break;
            }
            number = number.wrapping_mul(10).wrapping_add(u32::from(*digit));
        }
        Some(number)
    }
}

/// Sums the lengths of the fields; there are no more fields than bytes.
#[function]
pub fn fields(line: &[u8; 6]) -> u32 {
    let mut sum = 0_u32;
    #[bound(6)]
    for field in (Fields { rest: line }) {
        sum = sum.wrapping_add(field);
    }
    sum
}
