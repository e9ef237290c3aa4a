//! Chains that become several loops: `break` leaves all of them, and `continue` goes on with the next item.

#![allow(missing_docs, for_loops_over_fallibles)]

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Code {
    pub bits: u32,
    pub len: u8,
}

#[data]
impl Code {
    fn iter(self) -> impl DoubleEndedIterator<Item = bool> {
        (0..self.len.min(8)).rev().map(move |i| self.bits >> i & 1 == 1)
    }
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Book {
    pub codes: [Code; 3],
}

#[data]
impl Book {
    fn code(&self, symbol: u8) -> Option<Code> {
        self.codes.get(usize::from(symbol)).copied().filter(|code| code.len > 0)
    }

    /// Encodes symbols; an unknown one becomes `None`.
    fn encode<'a>(&'a self, symbols: &'a [u8]) -> impl Iterator<Item = Option<bool>> + 'a {
        symbols.iter().flat_map(move |&s| {
            let code = self.code(s % 4);
            let bad = code.is_none().then_some(None);
            code.into_iter().flat_map(Code::iter).map(Some).chain(bad)
        })
    }

    pub fn word(&self, symbols: [u8; 4]) -> (u64, usize, Option<Option<bool>>) {
        let mut word = 0_u64;
        for bit in self.encode(&symbols) {
            let Some(bit) = bit else { continue };
            if word > 1000 {
                break;
            }
            word = word << 1 | u64::from(bit);
        }
        let bad = self.encode(&symbols).filter(|bit| bit.is_none()).count();
        (word, bad, self.encode(&symbols).last())
    }

    pub fn known(&self, symbols: [u8; 4]) -> u32 {
        self.encode(&symbols).filter_map(|bit| bit).map(u32::from).sum()
    }
}

#[function]
pub fn nested(rows: [[u32; 3]; 4], limit: u32) -> [u32; 8] {
    let all = rows.iter().flat_map(|row| row.iter()).fold(0, |sum, x| u32::wrapping_add(sum, *x));
    let small = rows.iter().flat_map(|row| row.iter().take_while(|x| **x < limit)).count();
    let few = rows.iter().take_while(|row| row[0] < limit).flat_map(|row| row.iter()).count();
    let begun = rows.iter().flat_map(|row| row.iter()).take_while(|x| **x < limit).count();
    let found = rows.iter().flat_map(|row| row.iter().skip(1)).any(|x| *x == limit);
    let first = rows.iter().flat_map(|row| row.iter().copied()).find(|x| *x > limit);
    let numbered = rows
        .iter()
        .flat_map(|row| row.iter())
        .enumerate()
        .fold(0, |sum, (at, x)| u32::wrapping_add(sum, (at as u32).wrapping_mul(*x)));
    let deep = rows
        .iter()
        .flat_map(|row| row.iter().flat_map(|x| [*x, *x / 2]))
        .filter(|x| x % 3 == 1)
        .count();
    [
        all,
        small as u32,
        few as u32 + 100 * begun as u32,
        u32::from(found),
        first.unwrap_or(7),
        numbered,
        deep as u32,
        rows.iter().flat_map(|row| row.iter()).last().copied().unwrap_or(1),
    ]
}

#[function]
pub fn ranges(n: u8, of: u32) -> (u32, u32, u32) {
    let pairs = (0..n % 6)
        .flat_map(|y| (0..n % 4).map(move |x| (x, y)))
        .filter(|&(x, y)| of >> (x + 4 * y) & 1 == 1)
        .fold(0_u32, |sum, (x, y)| sum + u32::from(x) + 10 * u32::from(y));
    let some = (0..n % 6).flat_map(|y| (0..4).filter_map(move |x: u8| x.checked_sub(y))).max();
    let (code, last) = (3_u32, 4_u32);
    // Names of a closure are its own, also where they hide others.
    let hidden: u32 = (0..u32::from(n % 5))
        .flat_map(|x| {
            let code = x + 1;
            (0..code).map(move |last| last + code)
        })
        .map(|x| x * code + last)
        .sum();
    (pairs, u32::from(some.unwrap_or(9)), hidden)
}

/// `break` and `continue` in chains of several loops.
#[function]
pub fn left(rows: [[u32; 3]; 3], stop: u32, skip: u32) -> (u32, u32, u32) {
    let (mut sum, mut passes, mut rest) = (0_u32, 0, 0);
    for x in rows.iter().flat_map(|row| row.iter()) {
        if *x % 8 == skip % 8 {
            continue;
        }
        if *x % 16 == stop % 16 {
            break;
        }
        sum = sum.wrapping_add(*x);
    }
    'outer: for round in 0..3 {
        for x in rows.iter().flat_map(|row| row.iter().map(|x| x % 8)) {
            passes += 1;
            if x == stop % 8 {
                continue 'outer;
            }
            if x == skip % 8 && round > 0 {
                break 'outer;
            }
        }
        rest += 1;
    }
    let [one, other, _] = &rows;
    'all: for x in one.iter().map(|x| x % 8).chain(other.iter().map(|x| x % 4)) {
        for y in rows[2].iter().flat_map(|y| [y % 4, y % 5]) {
            if y == 3 {
                continue 'all;
            }
            if x == y {
                break 'all;
            }
            rest += 10;
        }
        rest += 100;
    }
    (sum, passes, rest)
}

#[function]
pub fn chained(xs: [f64; 3], ys: [f64; 2], more: Option<f64>, limit: f64) -> (f64, usize, Option<f64>, f64) {
    let sum = xs.iter().map(|x| x * 2.0).chain(ys.iter().map(|y| y - 1.0)).fold(0.0, |a, b| a + b);
    let below = xs.iter().map(|x| x * 2.0).chain(more).take_while(|x| *x < limit).count();
    let first = ys.iter().copied().filter(|y| *y > limit).chain(more).next();
    let mut last = 0.0;
    for (at, x) in xs.iter().filter(|x| **x > limit).chain(ys.iter()).enumerate() {
        if at == 3 {
            break;
        }
        last = *x + at as f64;
    }
    (sum, below, first, last)
}

/// A loop over an option.
#[function]
pub fn once(values: [Option<u32>; 4], mut spare: Option<u32>) -> (u32, u32, Option<u32>) {
    let (mut sum, mut seen) = (0_u32, 0);
    for value in values {
        seen += 1;
        for x in value {
            if x % 4 == 0 {
                break;
            }
            if x % 4 == 1 {
                continue;
            }
            sum = sum.wrapping_add(x);
        }
        for x in spare.iter_mut() {
            *x = x.wrapping_add(seen);
        }
    }
    for x in &spare {
        sum ^= x;
    }
    let all: u32 = values.iter().flat_map(|value| value.iter()).map(|x| x % 16).sum();
    (sum, all, spare)
}
