//! Keywords and names of the text form: when a name needs a handle, and the names of operations.

use alloc::format;
use alloc::string::String;

use crate::ir::{BinaryOp, CompareOp, Fault, Intrinsic, LogicOp, Routine};
use crate::number::Scalar;

/// Keywords, which are names only in quotes (scalar types are keywords as well).
const WORDS: [&str; 36] = [
    "module",
    "file",
    "struct",
    "enum",
    "const",
    "fn",
    "entry",
    "infallible",
    "private",
    "in",
    "as",
    "var",
    "let",
    "if",
    "else",
    "match",
    "for",
    "rev",
    "check",
    "return",
    "break",
    "continue",
    "true",
    "false",
    "mut",
    "unit",
    "matrix",
    "splat",
    "load",
    "array",
    "initial",
    "default",
    "params",
    "while",
    "loop",
    "_",
];

/// Returns true if `name` is a keyword.
pub(super) fn is_word(name: &str) -> bool {
    WORDS.contains(&name) || Scalar::from_name(name).is_some()
}

/// Returns `name` as the text shows it, in quotes if necessary.
pub(super) fn shown(name: &str) -> String {
    let mut chars = name.chars();
    let starts = chars.next().is_some_and(|first| first == '_' || first.is_ascii_alphabetic());
    if starts && chars.all(|next| next == '_' || next.is_ascii_alphanumeric()) && !is_word(name) {
        String::from(name)
    } else {
        format!("{name:?}")
    }
}

/// Precedences of `as`, of prefix operators, and of expressions that need no parentheses.
pub(super) const CAST: u8 = 10;
pub(super) const PREFIX: u8 = 11;
pub(super) const ATOM: u8 = 12;

/// Operators between two operands.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Infix {
    Binary(BinaryOp),
    Compare(CompareOp),
    Logic(LogicOp),
}

/// Operators with their precedences; a higher one binds tighter.
pub(super) const INFIX: [(&str, Infix, u8); 18] = [
    ("||", Infix::Logic(LogicOp::Or), 1),
    ("&&", Infix::Logic(LogicOp::And), 2),
    ("==", Infix::Compare(CompareOp::Eq), COMPARE),
    ("!=", Infix::Compare(CompareOp::Ne), COMPARE),
    ("<", Infix::Compare(CompareOp::Lt), COMPARE),
    ("<=", Infix::Compare(CompareOp::Le), COMPARE),
    (">", Infix::Compare(CompareOp::Gt), COMPARE),
    (">=", Infix::Compare(CompareOp::Ge), COMPARE),
    ("|", Infix::Binary(BinaryOp::Or), 4),
    ("^", Infix::Binary(BinaryOp::Xor), 5),
    ("&", Infix::Binary(BinaryOp::And), 6),
    ("<<", Infix::Binary(BinaryOp::Shl), 7),
    (">>", Infix::Binary(BinaryOp::Shr), 7),
    ("+", Infix::Binary(BinaryOp::Add), 8),
    ("-", Infix::Binary(BinaryOp::Sub), 8),
    ("*", Infix::Binary(BinaryOp::Mul), 9),
    ("/", Infix::Binary(BinaryOp::Div), 9),
    ("%", Infix::Binary(BinaryOp::Rem), 9),
];

/// Precedence of comparisons, which do not chain.
pub(super) const COMPARE: u8 = 3;

/// Returns the mark and the precedence of an operator.
pub(super) fn infix(op: Infix) -> (&'static str, u8) {
    let found = INFIX.iter().find(|entry| entry.1 == op);
    found.map_or(("?", 0), |entry| (entry.0, entry.2))
}

macro_rules! table {
    ($kind:ty: $all:ident, $name:ident, $find:ident => $($text:literal => $value:path,)*) => {
        /// All items, with their names in the text.
        pub const $all: &[(&str, $kind)] = &[$(($text, $value),)*];

        /// Returns the item's name in the text.
        pub(super) const fn $name(value: $kind) -> &'static str {
            match value {
                $($value => $text,)*
            }
        }

        /// Returns the item with this name in the text.
        pub(super) fn $find(name: &str) -> Option<$kind> {
            match name {
                $($text => Some($value),)*
                _ => None,
            }
        }
    };
}

table! {
    Intrinsic: INTRINSICS, intrinsic_name, intrinsic =>
    "sqrt" => Intrinsic::Sqrt,
    "abs" => Intrinsic::Abs,
    "min" => Intrinsic::Min,
    "max" => Intrinsic::Max,
    "clamp" => Intrinsic::Clamp,
    "floor" => Intrinsic::Floor,
    "to_bits" => Intrinsic::ToBits,
    "raw_bits" => Intrinsic::RawBits,
    "from_bits" => Intrinsic::FromBits,
    "copysign" => Intrinsic::Copysign,
    "wrapping_add" => Intrinsic::WrappingAdd,
    "wrapping_sub" => Intrinsic::WrappingSub,
    "wrapping_mul" => Intrinsic::WrappingMul,
    "wrapping_div" => Intrinsic::WrappingDiv,
    "wrapping_rem" => Intrinsic::WrappingRem,
    "saturating_add" => Intrinsic::SaturatingAdd,
    "saturating_sub" => Intrinsic::SaturatingSub,
    "saturating_mul" => Intrinsic::SaturatingMul,
    "div_euclid" => Intrinsic::DivEuclid,
    "rem_euclid" => Intrinsic::RemEuclid,
    "unsigned_abs" => Intrinsic::UnsignedAbs,
    "abs_diff" => Intrinsic::AbsDiff,
    "count_ones" => Intrinsic::CountOnes,
    "leading_zeros" => Intrinsic::LeadingZeros,
    "trailing_zeros" => Intrinsic::TrailingZeros,
    "swap_bytes" => Intrinsic::SwapBytes,
    "variant" => Intrinsic::Variant,
    "ceil" => Intrinsic::Ceil,
    "trunc" => Intrinsic::Trunc,
    "round" => Intrinsic::Round,
    "signum" => Intrinsic::Signum,
    "is_nan" => Intrinsic::IsNan,
    "is_finite" => Intrinsic::IsFinite,
    "is_infinite" => Intrinsic::IsInfinite,
}

table! {
    Routine: ROUTINES, routine_name, routine =>
    "add" => Routine::Add,
    "sub" => Routine::Sub,
    "neg" => Routine::Neg,
    "scale" => Routine::Scale,
    "unscale" => Routine::Unscale,
    "component_mul" => Routine::ComponentMul,
    "component_div" => Routine::ComponentDiv,
    "inf" => Routine::Inf,
    "sup" => Routine::Sup,
    "magnitudes" => Routine::Abs,
    "product" => Routine::Product,
    "tr_mul" => Routine::TrMul,
    "transpose" => Routine::Transpose,
    "dot" => Routine::Dot,
    "cross" => Routine::Cross,
    "norm" => Routine::Norm,
    "norm_squared" => Routine::NormSquared,
    "amax" => Routine::Amax,
    "amin" => Routine::Amin,
}

table! {
    Fault: FAULTS, fault_name, fault =>
    "overflow" => Fault::Overflow,
    "division_by_zero" => Fault::DivisionByZero,
    "shift" => Fault::Shift,
    "index" => Fault::Index,
    "clamp" => Fault::Clamp,
    "variant" => Fault::Variant,
    "assertion" => Fault::Assertion,
    "bound" => Fault::Bound,
    "absent" => Fault::Absent,
    "capacity" => Fault::Capacity,
    "left_out" => Fault::LeftOut,
}
