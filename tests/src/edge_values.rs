//! Edge values of each scalar type, as words.

use bessemer_ir::{Float, Int, Scalar};

/// Number of values for a function of several operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Breadth {
    /// All values: for one operand.
    All,
    /// Fewer values, so that all pairs can be tested.
    Pairs,
    /// Still fewer values, so that all triples can be tested.
    Triples,
}

/// The edge values of a type, each once.
pub fn of(scalar: Scalar, breadth: Breadth) -> Vec<u64> {
    let mut words = match scalar {
        Scalar::Bool => vec![0, 1],
        Scalar::Int(int) => integers(int, breadth),
        Scalar::Float(float) => floats(float, breadth),
    };
    words.sort_unstable();
    words.dedup();
    words
}

fn integers(int: Int, breadth: Breadth) -> Vec<u64> {
    let (min, max) = (int.min(), int.max());
    let mut values: Vec<i128> = match breadth {
        Breadth::All if int.bits() == 8 => (min..=max).collect(),
        Breadth::All => (0..64).flat_map(|bit| [-1, 0, 1].map(|by| (1 << bit) + by)).collect(),
        Breadth::Pairs => {
            vec![2, 3, 4, 5, 7, 8, 10, 15, 16, 31, 32, 33, 63, 64, 65, 100, 1 << 15, 1 << 16]
        }
        Breadth::Triples => vec![2, 7, max / 2],
    };
    values.extend(values.clone().into_iter().map(|value| -value));
    values.extend([0, 1, -1, min, min + 1, max - 1, max, min / 2, max / 2, max / 2 + 1, max / 3]);
    values.retain(|value| (min..=max).contains(value));
    values.into_iter().map(|value| value as u64).collect()
}

fn floats(float: Float, breadth: Breadth) -> Vec<u64> {
    let mut values = vec![0.0, 1.0, f64::INFINITY, f64::NAN, 0.5, 3.0];
    if breadth != Breadth::Triples {
        values.extend([1.5, 2.0, 2.5, 0.3, 7.0, 100.7, 1e10, 255.5, 4_294_967_296.0]);
        values.extend([9_223_372_036_854_775_808.0, core::f64::consts::FRAC_PI_2]);
    }
    if breadth == Breadth::All {
        let powers = (-70..70).map(|exponent| f64::powi(2.0, exponent));
        let near: Vec<f64> = powers
            .flat_map(|power| [power, power - 1.0, power + 1.0, power - 0.5, power + 0.5])
            .collect();
        values.extend(near);
        values.extend([1e300, 1e-300, 1e22, 710.0, 90.0, 180.0]);
    }
    values.extend(values.clone().into_iter().map(|value| -value));
    match float {
        Float::F64 => {
            let mut words: Vec<u64> = values.iter().map(|value| value.to_bits()).collect();
            let limits = [f64::MAX, f64::MIN_POSITIVE, f64::from_bits(1), f64::EPSILON];
            words.extend(limits.iter().flat_map(|it| [it.to_bits(), (-it).to_bits()]));
            if breadth == Breadth::All {
                let beside = |word: &u64| [*word, word.wrapping_sub(1), word.wrapping_add(1)];
                words = words.iter().flat_map(beside).collect();
            }
            words
        }
        Float::F32 => {
            let mut words: Vec<u32> =
                values.iter().map(|value| (*value as f32).to_bits()).collect();
            let limits = [f32::MAX, f32::MIN_POSITIVE, f32::from_bits(1), f32::EPSILON];
            words.extend(limits.iter().flat_map(|it| [it.to_bits(), (-it).to_bits()]));
            if breadth == Breadth::All {
                let beside = |word: &u32| [*word, word.wrapping_sub(1), word.wrapping_add(1)];
                words = words.iter().flat_map(beside).collect();
            }
            words.into_iter().map(u64::from).collect()
        }
    }
}
