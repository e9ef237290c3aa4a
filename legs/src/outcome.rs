//! The outcome of a call on a leg, and the comparison of outcomes.

use bessemer_ir::{Fault, Float, Module, Type};

/// The output words, or the fault.
pub type Outcome = Result<Vec<u64>, Fault>;

/// Converts the message of a panic of rustc, core or nalgebra to a fault.
pub fn fault(text: &str) -> Fault {
    match text {
        _ if text.contains("divide by zero") => Fault::DivisionByZero,
        _ if text.contains("divisor of zero") => Fault::DivisionByZero,
        _ if text.contains("attempt to shift") => Fault::Shift,
        _ if text.contains("overflow") => Fault::Overflow,
        _ if text.contains("out of bounds") || text.contains("out of range") => Fault::Index,
        _ if text.contains("slice index") || text.contains("slice length") => Fault::Index,
        _ if text.contains("copy_from_slice") || text.contains("mid > len") => Fault::Index,
        _ if text.contains("the container is full") => Fault::Capacity,
        _ if text.contains("within its bound") => Fault::Bound,
        _ if text.contains("`None` value") || text.contains("on an `Err` value") => Fault::Absent,
        _ if text.contains("on an `Ok` value") || text.contains("must be there") => Fault::Absent,
        _ if text.contains("low <= high") || text.contains("min > max") => Fault::Clamp,
        // The author's own words.
        _ => Fault::Assertion,
    }
}

/// Returns the words with zeros for content that is absent, since the legs may have any words there.
pub fn meant(module: &Module, types: &[Type], outcome: &Outcome) -> Outcome {
    outcome.clone().map(|mut words| {
        types.iter().fold(words.as_mut_slice(), |rest, ty| module.canonical(ty, rest));
        words
    })
}

/// Returns true if two outcomes are the same fault or the same bits.
pub fn same(one: &Outcome, other: &Outcome, leaves: &[Type]) -> bool {
    parted(one, other, leaves).is_empty()
}

/// Returns the indices of the words in which two outcomes differ; all NaN are equal. If one is a fault and the other
/// is not, all words differ. `leaves` are the types of the words.
pub fn parted(one: &Outcome, other: &Outcome, leaves: &[Type]) -> Vec<usize> {
    let (one, other) = match (one, other) {
        (Ok(one), Ok(other)) if one.len() == other.len() => (one, other),
        (one, other) if one == other => return Vec::new(),
        _ => return (0..leaves.len().max(1)).collect(),
    };
    let nan = |ty: &Type, word: u64| match ty.as_float() {
        Some(Float::F64) => f64::from_bits(word).is_nan(),
        Some(Float::F32) => f32::from_bits(word as u32).is_nan(),
        None => false,
    };
    let equal = |((a, b), ty): ((&u64, &u64), &Type)| a == b || nan(ty, *a) && nan(ty, *b);
    let pairs = one.iter().zip(other).zip(leaves).enumerate();
    pairs.filter(|(_, pair)| !equal(*pair)).map(|(place, _)| place).collect()
}
