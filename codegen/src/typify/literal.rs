//! Literals: from the author's digits to words of the type that the context gives.

use bessemer_ir::tree::Site;
use bessemer_ir::{Float, Int, Scalar, Type};

use super::{Result, problem};

/// The word of an integer literal as a value of `scalar`.
pub(super) fn integer(digits: &str, negative: bool, scalar: Scalar, site: Site) -> Result<u64> {
    let Ok(value) = digits.parse::<i128>() else {
        return problem(site, "this literal is out of range", "use a type that holds it");
    };
    let value = if negative { -value } else { value };
    match scalar {
        Scalar::Int(int) if (int.min()..=int.max()).contains(&value) => Ok(value as u64),
        Scalar::Float(_) => {
            let digits = if negative { format!("-{digits}") } else { digits.to_owned() };
            float(&digits, scalar, site)
        }
        _ => problem(
            site,
            format!("this literal is out of range for `{}`", scalar.name()),
            "use a type that holds it",
        ),
    }
}

/// The word of a float literal as a value of `scalar`.
pub(super) fn float(digits: &str, scalar: Scalar, site: Site) -> Result<u64> {
    let word = match scalar {
        Scalar::Float(Float::F64) => digits.parse::<f64>().ok().map(f64::to_bits),
        Scalar::Float(Float::F32) => {
            digits.parse::<f32>().ok().map(|value| u64::from(value.to_bits()))
        }
        _ => None,
    };
    match word {
        Some(word) => Ok(word),
        None => problem(site, "this literal is not a float here", "write an integer"),
    }
}

/// The type of an integer literal: its suffix, or what is expected, or Rust's default.
pub(super) fn integer_type(suffix: Option<Scalar>, expected: Option<&Type>) -> Scalar {
    match (suffix, expected) {
        (Some(scalar), _) => scalar,
        (None, Some(Type::Scalar(scalar @ (Scalar::Int(_) | Scalar::Float(_))))) => *scalar,
        _ => Scalar::Int(Int::I32),
    }
}

/// The type of a float literal: its suffix, or what is expected, or Rust's default.
pub(super) fn float_type(suffix: Option<Scalar>, expected: Option<&Type>) -> Scalar {
    match (suffix, expected) {
        (Some(scalar), _) => scalar,
        (None, Some(Type::Scalar(scalar @ Scalar::Float(_)))) => *scalar,
        _ => Scalar::Float(Float::F64),
    }
}
