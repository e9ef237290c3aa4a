//! Literals and names, each row with what it becomes.

use bessemer_ir::tree::{BinaryOp, Site};
use bessemer_ir::{Expr, Float, Int, Scalar, Span, Type};

use super::super::literal::{float, folded, integer, type_of};
use super::super::names::{constant, role, snake, split};

const F64: Scalar = Scalar::Float(Float::F64);
const F32: Scalar = Scalar::Float(Float::F32);

#[test]
fn integers_have_the_word_of_their_type() {
    let of = |digits, negative, scalar| integer(digits, negative, scalar, Site(1, 1)).ok();
    let int = Scalar::Int;
    assert_eq!(of("255", false, int(Int::U8)), Some(255));
    assert_eq!(of("256", false, int(Int::U8)), None);
    assert_eq!(of("1", true, int(Int::U8)), None);
    assert_eq!(of("128", true, int(Int::I8)), Some(-128_i64 as u64));
    assert_eq!(of("128", false, int(Int::I8)), None);
    assert_eq!(of("0x8000", false, int(Int::U16)), Some(0x8000));
    assert_eq!(of("18446744073709551615", false, int(Int::U64)), Some(u64::MAX));
    assert_eq!(of("18446744073709551616", false, int(Int::U64)), None);
    assert_eq!(of("9223372036854775808", true, int(Int::I64)), Some(1 << 63));
    assert_eq!(of("3", true, F64), Some((-3.0_f64).to_bits()));
    assert_eq!(of("1", false, Scalar::Bool), None);
}

#[test]
fn floats_are_rounded_once_to_their_type() {
    let of = |digits, scalar| float(digits, scalar, Site(1, 1)).ok();
    assert_eq!(of("0.1", F64), Some(0.1_f64.to_bits()));
    assert_eq!(of("0.1", F32), Some(u64::from(0.1_f32.to_bits())));
    // Rounded by way of a double, this would be 1.
    let once = "1.000000059604644775390626";
    assert_eq!(of(once, F32), Some(u64::from(1.000_000_1_f32.to_bits())));
    assert_eq!(of("1.5", Scalar::Int(Int::U8)), None);
}

#[test]
fn operations_on_literals_fold_as_long_as_they_fit() {
    let of = |op, a: i64, b: i64, int| {
        let literal =
            |word: i64| Expr::literal(word as u64, Type::Scalar(Scalar::Int(int)), Span::default());
        folded(op, &literal(a), &literal(b)).map(|word| word as i64)
    };
    assert_eq!(of(BinaryOp::Add, 200, 55, Int::U8), Some(255));
    assert_eq!(of(BinaryOp::Add, 200, 56, Int::U8), None);
    assert_eq!(of(BinaryOp::Sub, 3, 4, Int::U8), None);
    assert_eq!(of(BinaryOp::Sub, 3, 4, Int::I8), Some(-1));
    assert_eq!(of(BinaryOp::Div, -128, -1, Int::I8), None);
    assert_eq!(of(BinaryOp::Div, 1, 0, Int::I8), None);
    assert_eq!(of(BinaryOp::Rem, -7, 2, Int::I8), Some(-1));
    assert_eq!(of(BinaryOp::Shl, 1, 1, Int::U8), None);
}

#[test]
fn a_literal_has_its_suffix_or_the_expected_type_or_the_default() {
    let (i32, u8) = (Scalar::Int(Int::I32), Scalar::Int(Int::U8));
    assert_eq!(type_of(Some(u8), Some(&Type::F64), i32), u8);
    assert_eq!(type_of(None, Some(&Type::Scalar(u8)), i32), u8);
    assert_eq!(type_of(None, Some(&Type::F64), i32), F64);
    assert_eq!(type_of(None, Some(&Type::Scalar(u8)), F64), F64);
    assert_eq!(type_of(None, None, i32), i32);
}

#[test]
fn names_follow_the_authors() {
    for (name, expected) in [
        ("RateMatrix", "rate_matrix"),
        ("PID", "pid"),
        ("Vector3Of", "vector3_of"),
        ("already_snake", "already_snake"),
        ("", ""),
    ] {
        assert_eq!(snake(name), expected);
    }
    assert_eq!(role("Filter_f64"), "filter");
    assert_eq!(role("Filter_u8"), "filter_u8");
    assert_eq!(split("a::b::C"), ("a::b", "C"));
    assert_eq!(split("C"), ("", "C"));
}

#[test]
fn constants_are_named_by_module_or_type() {
    for (owner, path, module, name) in [
        (None, "LIMIT", "models::left", "LIMIT"),
        (None, "super::right::LIMIT", "models::right", "LIMIT"),
        (None, "crate::right::LIMIT", "models::right", "LIMIT"),
        (None, "Gains::LIMIT", "models::left", "GAINS_LIMIT"),
        (Some("Gains"), "Self::LIMIT", "models::left", "GAINS_LIMIT"),
        (None, "i8::MAX", "models::left", "I8_MAX"),
        (None, "core::f64::consts::PI", "models::f64::consts", "PI"),
    ] {
        let found = constant("models::left", owner, path);
        assert_eq!(found, (module.to_owned(), name.to_owned()), "{path}");
    }
}
