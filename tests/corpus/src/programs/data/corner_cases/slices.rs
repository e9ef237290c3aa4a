//! Slices of arrays, lists and slices, with every form of range.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    pub time: u32,
    pub value: f32,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Log {
    pub samples: [Sample; 5],
    pub count: usize,
}

#[data]
impl Log {
    pub fn kept(&self) -> u32 {
        latest(&self.samples[..self.count])
    }

    pub fn clear(&mut self, from: usize) {
        wipe(&mut self.samples[from..self.count]);
    }
}

#[function]
pub fn latest(samples: &[Sample]) -> u32 {
    let mut latest = 0;
    for sample in samples {
        if sample.time > latest {
            latest = sample.time;
        }
    }
    latest
}

#[function]
pub fn wipe(samples: &mut [Sample]) {
    samples.fill(Sample { time: 7, value: -1.0 });
}

#[function]
pub fn logged(log: &Log, more: usize) -> u32 {
    let kept = log.kept();
    kept / 2 + latest(&log.samples[more..]) / 2
}

#[function]
pub fn cleared(log: &mut Log, from: usize) {
    log.clear(from);
}

/// An element of a slice of a slice.
#[function]
pub fn inner(values: &[i32], from: usize, to: usize, at: usize) -> i32 {
    let part = &values[from..=to];
    let rest = &part[1..];
    rest[at].wrapping_add(part[0]).wrapping_add(rest.len() as i32)
}

#[function]
pub fn nested(values: &[i32; 7], from: usize, to: usize, at: usize) -> i32 {
    inner(values, from, to, at)
}

#[function]
pub fn nested_here(values: &[i32; 7], from: usize, to: usize, at: usize) -> i32 {
    let part = &values[from..=to];
    let rest = &part[1..];
    rest[at].wrapping_add(part[0]).wrapping_add(rest.len() as i32)
}

#[function]
pub fn written(values: &mut [i32; 7], from: usize, at: usize) {
    let part = &mut values[from..];
    part[at] = 12;
    part[0] = part[0].wrapping_sub(1);
    part[at] += 3;
}

#[function]
pub fn found(values: &[u8; 6], wanted: u8, from: usize) -> bool {
    values.contains(&wanted) && values[from..].contains(&wanted)
}

#[function]
pub fn turned(values: &mut [u16; 5], one: usize, other: usize) {
    values.reverse();
    values.swap(one, other);
    values[1..].reverse();
    values[2..4].fill(9);
}

#[function]
pub fn turned_list(values: &mut List<f32, 5>, one: usize, other: usize) {
    values.swap(one, other);
    values.reverse();
    values[1..].fill(0.5);
}

#[function]
pub fn ends(values: &List<f64, 4>, at: usize) -> f64 {
    let first = values.first().copied().unwrap_or(1.0);
    let last = match values.last() {
        Some(last) => *last,
        None => 2.0,
    };
    let middle = if let Some(value) = values.get(at) { *value } else { 3.0 };
    first * 4.0 + last * 2.0 + middle
}

#[function]
pub fn sample_at(log: &Log, at: usize) -> f32 {
    let Some(sample) = log.samples.get(at) else { return 0.0 };
    sample.value
}

/// Slices whose elements are arrays: rows of a table.
#[function]
pub fn total(rows: &[[f64; 3]], most: usize) -> f64 {
    let mut sum = 0.0;
    for row in &rows[..most] {
        for value in row {
            sum += value;
        }
    }
    sum + rows[0][2]
}

#[function]
pub fn table(rows: &[[f64; 3]; 4], from: usize, most: usize) -> f64 {
    total(&rows[from..], most) + total(rows, 2)
}

const PRIMES: [u32; 6] = [2, 3, 5, 7, 11, 13];

#[function]
pub fn sum(values: &[u32]) -> u32 {
    values.iter().sum()
}

#[function]
pub fn primes(from: usize, to: usize) -> u32 {
    sum(&PRIMES) + sum(&PRIMES[from..to]) + PRIMES[..to].iter().map(|prime| prime * prime).sum::<u32>()
}

#[function]
pub fn of_vector(v: &Vector3<f64>) -> f64 {
    scaled(v.as_slice(), 2.0)
}

#[function]
pub fn scaled(values: &[f64], factor: f64) -> f64 {
    values.iter().map(|value| value * factor).fold(0.0, |sum, value| sum + value)
}

/// A zip of slices with their index, as far as the shortest goes.
#[function]
pub fn together(a: &[i64; 6], b: &List<i64, 4>, from: usize) -> i64 {
    let mut sum: i64 = 0;
    for (x, y) in a[from..].iter().zip(b) {
        sum = sum.wrapping_add(x.wrapping_mul(*y));
    }
    for (i, x) in a[from..5].iter().enumerate() {
        sum = sum.wrapping_add(x.wrapping_mul(i as i64));
    }
    for x in a[1..from].iter().rev() {
        sum = sum.wrapping_mul(3).wrapping_add(*x);
    }
    sum
}

/// Reborrows of a slice.
#[function]
pub fn again(values: &mut [f64], depth: usize) {
    halve(&mut values[depth..]);
    halve(values);
}

#[function]
pub fn halve(values: &mut [f64]) {
    for value in values.iter_mut() {
        *value *= 0.5;
    }
}

#[function]
pub fn lent(values: &mut [f64; 5], depth: usize) {
    again(&mut values[1..], depth);
    again(values, 1);
}

#[function]
pub fn copied(to: &mut [u8; 8], from: &[u8; 4], at: usize, most: usize) {
    to[at..at + 4].copy_from_slice(from);
    to[..most].copy_from_slice(&from[..3]);
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frames {
    buffer: [u8; 8],
    used: usize,
}

#[component]
impl Frames {
    fn append(&mut self, bytes: &[u8]) -> usize {
        let end = self.used + bytes.len();
        self.buffer[self.used..end].copy_from_slice(bytes);
        self.used = end;
        end
    }

    #[entry]
    pub fn take(&mut self, bytes: &List<u8, 4>, skip: usize) -> usize {
        self.append(&bytes[skip..]) + self.append(b"ok")
    }
}
