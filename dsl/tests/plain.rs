//! Values as words, and back.

use bessemer::Plain;
use bessemer::prelude::*;
use proptest::prelude::*;

/// Something of everything.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Everything {
    /// A float.
    pub double: f64,
    /// A small float.
    pub single: f32,
    /// A flag.
    pub flag: bool,
    /// A mode.
    pub mode: Mode,
    /// Signed.
    pub signed: [i8; 2],
    /// Unsigned.
    pub unsigned: [u32; 2],
    /// A matrix.
    pub matrix: SMatrix<f64, 2, 3>,
    /// Another struct.
    pub inner: Inner,
}

/// A mode.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mode {
    /// Off.
    #[default]
    Idle,
    /// In the air.
    Flying,
    /// Down again.
    Landed,
}

/// Inside.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inner {
    /// A word.
    pub word: u64,
    /// A difference.
    pub difference: i64,
    /// An index.
    pub index: usize,
}

fn words<T: Plain>(value: &T) -> Vec<u64> {
    let mut words = Vec::new();
    value.store(&mut |word| words.push(word));
    words
}

fn read<T: Plain>(words: &[u64]) -> T {
    let mut words = words.iter().copied();
    T::load(&mut || words.next().unwrap_or(0))
}

const COUNT: usize = 4 + 2 + 2 + 6 + 3;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Any words make a value, and that value's words are stable.
    #[test]
    fn any_words_make_a_value(given in prop::collection::vec(any::<u64>(), COUNT)) {
        let value: Everything = read(&given);
        let stored = words(&value);
        prop_assert_eq!(stored.len(), COUNT);
        prop_assert_eq!(words(&read::<Everything>(&stored)), stored);
    }

    /// A float keeps its bits, those of a NaN included; the other words that fit stay too.
    #[test]
    fn words_that_fit_stay(double: u64, single: u32, signed: i8, unsigned: u32, index: usize) {
        let mut given = [0; COUNT];
        given[0] = double;
        given[1] = u64::from(single);
        given[4] = signed as u64;
        given[6] = u64::from(unsigned);
        given[COUNT - 1] = index as u64;
        prop_assert_eq!(words(&read::<Everything>(&given)), given);
    }
}

#[test]
fn words_come_in_order() {
    let value = Everything {
        double: 1.5,
        single: -0.0,
        flag: true,
        mode: Mode::Landed,
        signed: [-1, 2],
        unsigned: [3, u32::MAX],
        matrix: SMatrix::<f64, 2, 3>::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0),
        inner: Inner { word: 7, difference: -8, index: 9 },
    };
    let columns = [1.0_f64, 4.0, 2.0, 5.0, 3.0, 6.0].map(f64::to_bits);
    let mut expected = vec![1.5_f64.to_bits(), 1 << 31, 1, 2, u64::MAX, 2, 3, u64::from(u32::MAX)];
    expected.extend(columns);
    expected.extend([7, -8_i64 as u64, 9]);
    assert_eq!(words(&value), expected);
    assert_eq!(read::<Everything>(&expected), value);
}

#[test]
fn words_out_of_range_are_cut() {
    assert_eq!(read::<u8>(&[0x1ff]), 0xff);
    assert_eq!(read::<i8>(&[0x80]), -128);
    assert!(read::<bool>(&[2]));
    assert_eq!(read::<Mode>(&[3]), Mode::Idle);
    assert_eq!(read::<f32>(&[1 << 40]), 0.0);
}
