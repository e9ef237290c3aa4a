//! Methods of an author's types with the names of those of lists and iterators; and implementations of `Extend`.

#![allow(missing_docs)]

use bessemer::prelude::*;

/// A list of numbers that halves each number added.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Halves {
    pub sum: f64,
    pub at: u32,
}

#[data]
impl Halves {
    pub fn push(&mut self, number: f64) {
        self.sum += 0.5 * number;
    }
    pub fn extend(&mut self, numbers: [f64; 3]) {
        self.sum += numbers[0] + numbers[1] + numbers[2];
    }
    pub fn retain(&mut self, wanted: bool) {
        if !wanted {
            self.sum *= 0.5;
        }
    }
    pub fn skip(&mut self, count: u32) {
        self.at = self.at.wrapping_add(count);
    }
    pub fn take(&mut self, count: u32) -> u32 {
        self.at = self.at.wrapping_mul(count);
        self.at
    }
    pub fn step_by(&mut self, step: u32) {
        self.at ^= step;
    }
    pub fn chain(self, other: Halves) -> Halves {
        Halves { sum: self.sum - other.sum, at: other.at }
    }
}

/// A sum of bytes and of words, modulo `M`.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum<const M: u32> {
    pub sum: u32,
}

#[data]
impl<'a, const M: u32> Extend<&'a u8> for Sum<M> {
    fn extend<I: IntoIterator<Item = &'a u8>>(&mut self, bytes: I) {
        self.sum = bytes.into_iter().fold(self.sum, |sum, &byte| sum.wrapping_mul(M) ^ u32::from(byte));
    }
}

#[data]
impl<const M: u32> Extend<u32> for Sum<M> {
    fn extend<I: IntoIterator<Item = u32>>(&mut self, words: I) {
        for word in words {
            self.sum = self.sum.wrapping_add(word);
        }
    }
}

#[function]
pub fn own(halves: &mut Halves, numbers: [f64; 3], wanted: bool, count: u32) -> Halves {
    halves.push(numbers[1]);
    halves.extend(numbers);
    Halves::extend(halves, numbers);
    halves.retain(wanted);
    halves.skip(3);
    let taken = halves.take(count);
    halves.step_by(taken);
    halves.chain(Halves { sum: 1.0, at: taken })
}

#[function]
pub fn sums(bytes: [u8; 6], count: usize, words: [u32; 2]) -> [u32; 2] {
    let mut one = Sum::<31> { sum: 0 };
    one.extend(&bytes);
    one.extend(&bytes[..count % 7]);
    one.extend(bytes[1..].iter().filter(|byte| **byte > 9));
    one.extend(words);
    let mut other = Sum::<7> { sum: one.sum };
    other.extend(words.iter().map(|word| word / 2));
    let mut list = List::<u8, 16>::new();
    list.extend(bytes.iter().rev());
    list.extend(words.iter().map(|word| *word as u8));
    list.extend([1, 2]);
    other.extend(list.iter());
    [one.sum, other.sum]
}
