//! Reads the reference values, and compares with them.

use std::collections::HashMap;

use bessemer::prelude::{Real, real};

/// Named lists of numbers.
pub struct Data(HashMap<String, Vec<f64>>);

impl Data {
    /// Reads the text of a file: a line is a name and its numbers.
    pub fn read(text: &str) -> Data {
        let line = |line: &str| {
            let mut words = line.split(' ');
            let name = words.next().expect("a name").to_owned();
            (name, words.map(|word| number(word).expect("a number")).collect())
        };
        Data(text.lines().map(line).collect())
    }

    /// Returns the numbers of a name.
    pub fn get<T: Real>(&self, name: &str) -> Vec<T> {
        self.0[name].iter().map(|number| real(*number)).collect()
    }

    /// Returns the numbers of a name in rows.
    pub fn rows<T: Real, const N: usize>(&self, name: &str) -> Vec<[T; N]> {
        let numbers = self.get(name);
        let (rows, rest) = numbers.as_chunks();
        assert!(rest.is_empty(), "{name}");
        rows.to_vec()
    }

    /// Returns the numbers of a name, of which there are `N`.
    pub fn all<T: Real, const N: usize>(&self, name: &str) -> [T; N] {
        self.get(name).try_into().expect("as many numbers")
    }
}

fn number(word: &str) -> Option<f64> {
    word.parse().ok()
}

/// Checks that numbers equal reference values, relative to the largest of them.
#[track_caller]
pub fn near<T: Real>(found: &[T], expected: &[T], digits: i32) {
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(1e-30, |most: f64, it| most.max(it.as_f64().abs()));
    // Single precision has nine digits fewer.
    let digits = if size_of::<T>() == 4 { (digits - 9).min(6) } else { digits };
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        let off = (found.as_f64() - expected.as_f64()).abs() / largest;
        assert!(off < 10_f64.powi(-digits), "{index}: {found:?} is not {expected:?}");
    }
}
