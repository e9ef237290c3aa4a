//! Adapters in any order, with repeated names, states that are structs, and faults in the middle.

use bessemer::prelude::*;

/// State of a chain.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Level {
    /// Height.
    pub height: i32,
    /// Number of occurrences.
    pub count: u8,
}

#[data]
impl Level {
    /// An author's method with the name of an adapter.
    pub fn scan(&mut self, by: i32, more: i32) -> i32 {
        self.height = by;
        more
    }

    /// An author's method with the name of an iterator's method.
    pub fn nth(&self, n: u8) -> u8 {
        self.count.wrapping_add(n)
    }

    /// An author's method with the name of an adapter.
    pub fn skip_while(&self, n: i32) -> i32 {
        n
    }

    /// An author's method with the name of an iterator's method.
    pub fn next(&mut self) -> u8 {
        self.count = self.count.wrapping_add(1);
        self.count
    }
}

/// Calls of the author's methods are not taken for the iterator's.
#[function]
pub fn own(level: &mut Level) -> i32 {
    let a = level.scan(3, 4);
    let b = level.nth(2);
    let c = level.skip_while(5);
    let d = level.next();
    a + i32::from(b) + c + i32::from(d)
}

/// Parameters of closures use names again, and hide variables.
#[function]
pub fn names(values: &[i32; 5], x: i32) -> i32 {
    let state = 3;
    let skipping = 2;
    let sum: i32 = values
        .iter()
        .skip_while(|v| **v < x)
        .scan(state, |state, v| {
            *state += v;
            Some(*state * skipping)
        })
        .skip_while(|v| *v < state)
        .map(|v| v + state + skipping)
        .sum();
    sum + state + x
}

/// Skipped items are not computed; a fault before or after them occurs.
#[function]
pub fn skipped(values: &[u8; 5], divisor: u8) -> u32 {
    let mut asked = 0_u32;
    let mut sum = 0_u32;
    for value in values.iter().skip_while(|value| 100 / **value > divisor) {
        asked += 1;
        sum += u32::from(*value);
        if *value == 9 {
            continue;
        }
        if *value == 7 {
            break;
        }
        sum += 1;
    }
    100 * asked + sum
}

/// Sources: a slice that may be empty, its reverse, a range, and an enumerated one.
#[function]
pub fn sources(values: &List<i16, 4>, n: i16) -> i32 {
    let back: i32 = values.iter().rev().skip_while(|x| **x > n).map(|x| i32::from(*x)).sum();
    let range: i32 = (0..6).skip_while(|x| x * x < i32::from(n)).sum();
    let indexed = values.iter().enumerate().skip_while(|(i, x)| *i < 2 && **x < n).count();
    back.wrapping_add(range).wrapping_add(indexed as i32)
}

/// A struct as the state of `scan`, changed field by field; the chain ends before the fault.
#[function]
pub fn levels(flows: &[i32; 5], start: Level) -> (i32, u8) {
    let mut last = Level::default();
    for level in flows.iter().scan(start, |level, flow| {
        if *flow == 7 {
            return_none()
        } else {
            level.height += flow;
            level.count += 1;
            Some(*level)
        }
    }) {
        last = level;
    }
    (last.height, last.count)
}

/// Returns `None`.
#[function]
pub fn return_none() -> Option<Level> {
    None
}

/// Ends at the first item that does not fit, and destructures pairs.
#[function]
pub fn while_some(values: &[Option<(u8, i8)>; 4], limit: i8) -> i32 {
    let sum: i32 = values
        .iter()
        .map_while(|value| *value)
        .map_while(|(a, b)| if b < limit { Some(i32::from(a) - i32::from(b)) } else { None })
        .filter(|x| *x != 3)
        .sum();
    let count = values.iter().map_while(|value| value.map(|(a, _)| a)).filter(|a| *a > 1).count();
    sum + count as i32
}

/// Nested loops, both with labels.
#[function]
pub fn labelled(rows: &[[i32; 3]; 3]) -> i32 {
    let mut sum = 0;
    'rows: for row in rows {
        'row: for x in row.iter().map_while(|x| if *x > 0 { Some(x / 2) } else { None }) {
            if x == 2 {
                continue 'row;
            }
            if x == 3 {
                continue 'rows;
            }
            if x == 5 {
                break 'rows;
            }
            sum += x;
        }
        sum += 100;
    }
    sum
}

/// The nth items of what remains.
#[function]
pub fn numbers(values: &[u8; 5], n: usize) -> [Option<u8>; 4] {
    [
        values.iter().copied().nth(n),
        values.iter().copied().filter(|x| *x > 2).nth(1),
        values.iter().rev().skip(1).copied().next(),
        values.iter().map(|x| x / 2).skip_while(|x| *x > 3).nth(0),
    ]
}

/// Index of the last match in a list and in a slice.
#[function]
pub fn last_places(values: &List<i32, 5>, array: &[f32; 4], x: i32) -> Option<usize> {
    let one = values.iter().rposition(|value| *value == x)?;
    let other = array[1..].iter().rposition(|value| value.is_nan() || *value > 0.5)?;
    Some(10 * one + other)
}

/// Zips of sequences of different lengths, reversed on one or both sides, and of three sequences.
#[function]
pub fn together(a: &[i32; 3], b: &[i32; 5], c: &List<i32, 4>) -> [i32; 4] {
    let mut sums = [0; 4];
    for (x, y) in a.iter().zip(b.iter().rev()) {
        sums[0] = 3 * sums[0] % 1000 + x % 7 * (y % 5);
    }
    for (x, y) in a.iter().rev().zip(c) {
        sums[1] = 3 * sums[1] % 1000 + x % 7 * (y % 5);
    }
    for ((x, y), z) in c.iter().rev().zip(b.iter().rev()).zip(a) {
        sums[2] = 3 * sums[2] % 1000 + x % 7 * (y % 5) + z % 3;
    }
    for (i, (x, y)) in c.iter().zip(b.iter().rev()).enumerate() {
        sums[3] = 3 * sums[3] % 1000 + x % 7 * (y % 5) + i as i32;
    }
    sums
}

/// Writes to reversed elements.
#[function]
pub fn mirrored(a: &[i32; 4], b: &mut [i32; 4]) {
    for (x, y) in a.iter().zip(b.iter_mut().rev()) {
        *y = y.wrapping_add(*x);
    }
}
