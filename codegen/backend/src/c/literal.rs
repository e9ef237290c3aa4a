//! Formats words as C constants that read back to the same bits.

use bessemer_ir::{Const, Float, Int, Scalar, Type};

use super::names::Names;
use super::tree::Expr;

/// Largest number of decimal digits of a power of two that a reader recognises: 16777216.
const READABLE: usize = 8;

/// The languages of those that read a constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Readers {
    /// C: a source.
    C,
    /// C and C++: a header. C++ has binary floats since 2017 only.
    Cpp,
}

/// Returns a scalar or an enum as a C constant.
pub fn word(names: &Names, ty: &Type, word: u64, readers: Readers) -> Expr {
    match ty {
        Type::Scalar(Scalar::Bool) => Expr::name(if word == 0 { "false" } else { "true" }),
        Type::Scalar(Scalar::Int(int)) => integer(*int, int.from_word(word)),
        Type::Scalar(Scalar::Float(float)) => number(*float, word, readers),
        Type::Enum(id) => Expr::name(names.variant(*id, word)),
        other => unreachable!("no word: {other:?}"),
    }
}

/// Returns a float from its bits.
pub fn number(float: Float, bits: u64, readers: Readers) -> Expr {
    let text = |value: f64, decimal: String| match readers {
        Readers::C => binary(value).filter(|_| is_obscure(&decimal)).unwrap_or(decimal),
        Readers::Cpp => decimal,
    };
    let (magnitude, negative) = match float {
        Float::F64 => {
            let value = f64::from_bits(bits);
            let text = match value.abs() {
                value if value.is_nan() => "(double)NAN".to_owned(),
                value if value.is_infinite() => "(double)INFINITY".to_owned(),
                value => text(value, format!("{value:?}")),
            };
            (text, value.is_sign_negative() && !value.is_nan())
        }
        Float::F32 => {
            let value = f32::from_bits(bits as u32);
            let text = match value.abs() {
                value if value.is_nan() => "NAN".to_owned(),
                value if value.is_infinite() => "INFINITY".to_owned(),
                value => text(value.into(), format!("{value:?}")) + "F",
            };
            (text, value.is_sign_negative() && !value.is_nan())
        }
    };
    let value = match magnitude.strip_prefix("(double)") {
        Some(name) => Expr::cast("double", Expr::name(name)),
        None => Expr::Name(magnitude),
    };
    if negative { Expr::unary("-", value) } else { value }
}

/// Returns true if a decimal number hides a power of two by its digits or its exponent.
fn is_obscure(decimal: &str) -> bool {
    let digits = decimal.trim_start_matches(['0', '.']).trim_end_matches(".0");
    digits.len() > READABLE || digits.contains('e')
}

/// Returns a positive number as a power of two, or half more than one: `0x1p1023`, `0x1.8p52`.
fn binary(value: f64) -> Option<String> {
    const MANTISSA: u64 = (1 << 52) - 1;
    const HALF: u64 = 1 << 51;
    let significand = match value.to_bits() & MANTISSA {
        0 if value.is_normal() => "1",
        HALF if value.is_normal() => "1.8",
        _ => return None,
    };
    let exponent = (value.to_bits() >> 52) as i64 - 1023;
    Some(format!("0x{significand}p{exponent}"))
}

/// Returns true if [`number`] needs `math.h` for these bits.
pub fn needs_math(ty: &Type, word: u64) -> bool {
    match ty.as_float() {
        Some(Float::F64) => !f64::from_bits(word).is_finite(),
        Some(Float::F32) => !f32::from_bits(word as u32).is_finite(),
        None => false,
    }
}

/// Returns C's name of a constant of Rust's floats, such as `f64::NAN` or `f64::MAX`, and its header.
///
/// An author's constant with this name and value is treated equally.
pub fn word_of_c(item: &Const) -> Option<(Expr, &'static str)> {
    let (ty, name) = item.name.split_once('_').filter(|_| item.docs.is_empty())?;
    let float = item.ty.as_float()?;
    let (of_rust, kind, limits) = match float {
        Float::F64 => ("F64", "DBL", [f64::MAX, f64::MIN_POSITIVE, f64::EPSILON].map(f64::to_bits)),
        Float::F32 => {
            let limits = [f32::MAX, f32::MIN_POSITIVE, f32::EPSILON];
            ("F32", "FLT", limits.map(|limit| u64::from(limit.to_bits())))
        }
    };
    let [word] = item.words[..] else { return None };
    if ty != of_rust {
        return None;
    }
    let sign = 1 << (float.bits_type().bits() - 1);
    let limit = |of: &str| Expr::name(format!("{kind}_{of}"));
    let [most, least_normal, epsilon] = limits;
    // C's least is the least above zero.
    let (bits, expr) = match name {
        "MAX" => (most, limit("MAX")),
        "MIN" => (most | sign, Expr::unary("-", limit("MAX"))),
        "MIN_POSITIVE" => (least_normal, limit("MIN")),
        "EPSILON" => (epsilon, limit("EPSILON")),
        "NAN" | "INFINITY" | "NEG_INFINITY" => {
            return needs_math(&item.ty, word)
                .then(|| (number(float, word, Readers::Cpp), "math.h"));
        }
        _ => return None,
    };
    (bits == word).then_some((expr, "float.h"))
}

/// Returns true if a number is better read as a bit pattern than as a quantity.
pub fn is_by_bits(ty: &Type, word: u64) -> bool {
    ty.as_int().is_some_and(|int| {
        let value = int.from_word(word);
        value != int.max() && is_pattern(int, value.unsigned_abs())
    })
}

/// Returns an integer in hexadecimal; a negative one in decimal, and a limit of 32 bits or more by its name.
pub fn hexadecimal(int: Int, value: i128) -> Expr {
    Expr::name(match (int.bits(), int.signed()) {
        (bits, _) if value < 0 || bits > 16 && value == int.max() => return integer(int, value),
        (64, false) => format!("UINT64_C(0x{value:X})"),
        (64, true) => format!("INT64_C(0x{value:X})"),
        (_, false) => format!("0x{value:X}U"),
        (_, true) => format!("0x{value:X}"),
    })
}

/// Returns an unsigned integer that is a bit pattern.
pub fn bits(int: Int, value: i128) -> Expr {
    match int.bits() {
        _ if value < 10 => integer(int, value),
        32 | 64 if value == int.max() => integer(int, value),
        _ => hexadecimal(int, value),
    }
}

/// Returns an integer with the suffix of its type.
pub fn integer(int: Int, value: i128) -> Expr {
    if value == int.min() && int.signed() {
        return Expr::name(format!("INT{}_MIN", int.bits()));
    }
    if value == int.max() && int.bits() > 8 {
        let unsigned = if int.signed() { "" } else { "U" };
        return Expr::name(format!("{unsigned}INT{}_MAX", int.bits()));
    }
    let digits = value.unsigned_abs();
    let digits = if is_pattern(int, digits) { format!("0x{digits:X}") } else { digits.to_string() };
    let magnitude = Expr::name(match (int.bits(), int.signed()) {
        (64, true) => format!("INT64_C({digits})"),
        (64, false) => format!("UINT64_C({digits})"),
        (_, true) => digits,
        (_, false) => format!("{digits}U"),
    });
    if value < 0 { Expr::unary("-", magnitude) } else { magnitude }
}

/// Returns true if an unsigned number looks like a bit pattern: at least 2²⁰, and no multiple of 100.
fn is_pattern(int: Int, value: u128) -> bool {
    !int.signed() && value >= 1 << 20 && !value.is_multiple_of(100)
}

#[cfg(test)]
mod tests {
    use super::{Float, Readers, number};
    use crate::c::tree::Expr;

    /// Powers of two whose digits hide them are binary, with the same bits; short and inexact numbers stay decimal.
    #[test]
    fn hidden_powers_of_two_are_binary() {
        for (value, text) in [
            (0.0, "0.0"),
            (0.125, "0.125"),
            (2.0_f64.powi(-11), "0.00048828125"),
            (2.0_f64.powi(-12), "0x1p-12"),
            (2.0_f64.powi(-27), "0x1p-27"),
            (16_777_216.0, "16777216.0"),
            (2.0_f64.powi(53), "0x1p53"),
            (1.5 * 2.0_f64.powi(52), "0x1.8p52"),
            (1.25 * 2.0_f64.powi(52), "5629499534213120.0"),
            (2.0_f64.powi(1023), "0x1p1023"),
            (f64::MIN_POSITIVE, "0x1p-1022"),
            (f64::MIN_POSITIVE / 2.0, "1.1125369292536007e-308"),
            (0.1, "0.1"),
            (1e300, "1e300"),
        ] {
            assert_eq!(
                number(Float::F64, value.to_bits(), Readers::C),
                Expr::name(text),
                "{value}"
            );
        }
        let single = |value: f32| number(Float::F32, value.to_bits().into(), Readers::C);
        assert_eq!(single(2.0_f32.powi(60)), Expr::name("0x1p60F"));
        assert_eq!(single(-2.0_f32.powi(-60)), Expr::unary("-", Expr::name("0x1p-60F")));
        assert_eq!(single(8_388_608.0), Expr::name("8388608.0F"));
        let in_header = number(Float::F64, 2.0_f64.powi(60).to_bits(), Readers::Cpp);
        assert_eq!(in_header, Expr::name("1.152921504606847e18"));
    }
}
