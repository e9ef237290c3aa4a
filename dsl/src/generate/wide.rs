//! Operators, conversions and methods of integers of 128 bits.
//!
//! An operator is found by the types in its slots. `as` has no expression that rustc could look up, so its functions are
//! in the registry of conversions, under the name [`tree::AS`].

#![allow(missing_docs)]

use alloc::boxed::Box;
use core::num::TryFromIntError;

use bessemer_tree as tree;
use bessemer_tree::number::{Int, Scalar};
use bessemer_tree::visit::{VisitMut, walk_expr_mut};
use bessemer_tree::{Expr, ExprKind, Ty};

use super::builder::{Builder, Callee, OwnOperator, Witness};
use super::companions::companions;
use super::comparison::Extremes;
use super::numbers::{
    BytesBuiltins, DivisionBuiltins, FromBuiltin, OrderBuiltins, SignBuiltins, TryFromBuiltin,
    converts,
};
use super::slot::{Called, DslType, Seen, dsl_types};
use crate::wide::{i128 as signed, u128 as unsigned};

dsl_types! {
    [] [] u128 as Self => |cx| unsigned::U128::ty(cx);
    [] [] i128 as Self => |cx| signed::I128::ty(cx);
}

fn of<M: Callee>(cx: &mut Builder) -> Option<tree::Callee> {
    Some(M::callee(cx))
}

/// Returns the function of an operator whose value is an integer of 128 bits; none for any other operator.
pub(super) fn operator(
    cx: &mut Builder,
    operator: &tree::Operator,
    slots: &[Ty],
) -> Option<tree::Callee> {
    let Ty::Named(path) = slots.get(operator.at as usize)? else { return None };
    // A literal has no slot.
    let right = operator.operands.get(1).copied().flatten();
    let right = right.and_then(|slot| slots.get(slot as usize));
    let sign = operator.of.trim_end_matches("Assign");
    match path.as_str() {
        "bessemer::wide::u128::U128" => of_unsigned(cx, sign, right),
        "bessemer::wide::i128::I128" if sign == "Neg" => of::<signed::negative>(cx),
        "bessemer::wide::i128::I128" => of_signed(cx, sign, right),
        _ => None,
    }
}

/// Defines the operators and the methods that both have.
macro_rules! wide {
    ($wide:ident $module:ident: $operators:ident $trait:ident) => {
        fn $operators(cx: &mut Builder, sign: &str, right: Option<&Ty>) -> Option<tree::Callee> {
            match sign {
                "Add" => of::<$module::sum>(cx),
                "Sub" => of::<$module::difference>(cx),
                "Mul" => of::<$module::product>(cx),
                "Div" => of::<$module::div>(cx),
                "Rem" => of::<$module::rem>(cx),
                "BitAnd" => of::<$module::both>(cx),
                "BitOr" => of::<$module::either>(cx),
                "BitXor" => of::<$module::differing>(cx),
                "Not" => of::<$module::opposite>(cx),
                "Shl" | "Shr" => match (right, sign == "Shl") {
                    (Some(Ty::Scalar(Scalar::Int(Int::I8))), true) => of::<$module::shl_i8>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::I8))), false) => of::<$module::shr_i8>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::I16))), true) => of::<$module::shl_i16>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::I16))), false) => of::<$module::shr_i16>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::I32))), true) => of::<$module::shl_i32>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::I32))), false) => of::<$module::shr_i32>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::I64))), true) => of::<$module::shl_i64>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::I64))), false) => of::<$module::shr_i64>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::Isize))), true) => of::<$module::shl_isize>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::Isize))), false) => of::<$module::shr_isize>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::U8))), true) => of::<$module::shl_u8>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::U8))), false) => of::<$module::shr_u8>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::U16))), true) => of::<$module::shl_u16>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::U16))), false) => of::<$module::shr_u16>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::U32))), true) => of::<$module::shl_u32>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::U32))), false) => of::<$module::shr_u32>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::U64))), true) => of::<$module::shl_u64>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::U64))), false) => of::<$module::shr_u64>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::Usize))), true) => of::<$module::shl_usize>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::Usize))), false) => of::<$module::shr_usize>(cx),
                    (_, true) => of::<$module::shl_u32>(cx),
                    (_, false) => of::<$module::shr_u32>(cx),
                },
                _ => None,
            }
        }

        companions! {
            /// Methods of the type.
            pub trait $trait: Sized {
                fn __b_wrapping_add(self, _other: $wide) -> $wide = [$module::wrapping_add];
                fn __b_wrapping_sub(self, _other: $wide) -> $wide = [$module::wrapping_sub];
                fn __b_wrapping_mul(self, _other: $wide) -> $wide = [$module::wrapping_mul];
                fn __b_saturating_add(self, _other: $wide) -> $wide = [$module::saturating_add];
                fn __b_saturating_sub(self, _other: $wide) -> $wide = [$module::saturating_sub];
                fn __b_saturating_mul(self, _other: $wide) -> $wide = [$module::saturating_mul];
                fn __b_wrapping_neg(self) -> $wide = [$module::wrapping_neg];
                fn __b_checked_add(self, _other: $wide) -> Option<$wide> = [$module::checked_add];
                fn __b_checked_sub(self, _other: $wide) -> Option<$wide> = [$module::checked_sub];
                fn __b_checked_mul(self, _other: $wide) -> Option<$wide> = [$module::checked_mul];
                fn __b_checked_div(self, _other: $wide) -> Option<$wide> = [$module::checked_div];
                fn __b_checked_rem(self, _other: $wide) -> Option<$wide> = [$module::checked_rem];
                fn __b_checked_neg(self) -> Option<$wide> = [$module::checked_neg];
                fn __b_checked_shl(self, _bits: u32) -> Option<$wide> = [$module::checked_shl];
                fn __b_checked_shr(self, _bits: u32) -> Option<$wide> = [$module::checked_shr];
                fn __b_overflowing_add(self, _other: $wide) -> ($wide, bool) = [$module::overflowing_add];
                fn __b_overflowing_sub(self, _other: $wide) -> ($wide, bool) = [$module::overflowing_sub];
                fn __b_overflowing_mul(self, _other: $wide) -> ($wide, bool) = [$module::overflowing_mul];
                fn __b_wrapping_shl(self, _bits: u32) -> $wide = [$module::wrapping_shl];
                fn __b_wrapping_shr(self, _bits: u32) -> $wide = [$module::wrapping_shr];
                fn __b_rotate_left(self, _bits: u32) -> $wide = [$module::rotate_left];
                fn __b_rotate_right(self, _bits: u32) -> $wide = [$module::rotate_right];
                fn __b_pow(self, _bits: u32) -> $wide = [$module::pow];
                fn __b_wrapping_pow(self, _bits: u32) -> $wide = [$module::wrapping_pow];
                fn __b_count_ones(self) -> u32 = [$module::count_ones];
                fn __b_count_zeros(self) -> u32 = [$module::count_zeros];
                fn __b_leading_zeros(self) -> u32 = [$module::leading_zeros];
                fn __b_leading_ones(self) -> u32 = [$module::leading_ones];
                fn __b_trailing_zeros(self) -> u32 = [$module::trailing_zeros];
                fn __b_trailing_ones(self) -> u32 = [$module::trailing_ones];
                fn __b_swap_bytes(self) -> $wide = [$module::swap_bytes];
                fn __b_abs_diff(self, _other: $wide) -> u128 = [$module::abs_diff];
            }
        }

        // For references, which rustc tries last: a number whose type it infers later has the methods of other integers.
        impl $trait for &$wide {}

        impl OrderBuiltins for $wide {
            type Abs = signed::abs;
            type Min = <$wide as Extremes>::Min;
            type Max = <$wide as Extremes>::Max;
            type Clamp = <$wide as Extremes>::Clamp;
        }

        impl BytesBuiltins for $wide {
            type Bytes = [u8; 16];
            type ToLe = $module::to_le_bytes;
            type ToBe = $module::to_be_bytes;
            type FromLe = $module::from_le_bytes;
            type FromBe = $module::from_be_bytes;
        }
    };
}

wide! { u128 unsigned: of_unsigned UnsignedWideBuiltins }
wide! { i128 signed: of_signed SignedWideBuiltins }

companions! {
    pub mod traits[UnsignedWideBuiltins SignedWideBuiltins];
    /// Methods of unsigned integers alone.
    impl[] OwnUnsignedBuiltins for &u128 {
        fn __b_is_power_of_two(self) -> bool = [unsigned::is_power_of_two];
        fn __b_ilog2(self) -> u32 = [unsigned::ilog2];
        fn __b_checked_ilog2(self) -> Option<u32> = [unsigned::checked_ilog2];
        fn __b_isqrt(self) -> u128 = [unsigned::isqrt];
    }
    /// Methods of signed integers alone.
    impl[] OwnSignedBuiltins for &i128 {
        fn __b_unsigned_abs(self) -> u128 = [signed::unsigned_abs];
        fn __b_wrapping_abs(self) -> i128 = [signed::wrapping_abs];
        fn __b_checked_abs(self) -> Option<i128> = [signed::checked_abs];
        fn __b_is_negative(self) -> bool = [signed::is_negative];
        fn __b_is_positive(self) -> bool = [signed::is_positive];
    }
}

impl SignBuiltins for i128 {
    type Signum = signed::signum;
}

impl DivisionBuiltins for u128 {
    type DivEuclid = unsigned::div;
    type RemEuclid = unsigned::rem;
}

impl DivisionBuiltins for i128 {
    type DivEuclid = signed::div_euclid;
    type RemEuclid = signed::rem_euclid;
}

macro_rules! casts {
    ($($from:ident => $to:ident: $module:ident $function:ident;)*) => {$(
        super::register! {
            OwnOperator {
                name: tree::AS,
                left: <$to as DslType>::ty,
                right: <$from as DslType>::ty,
                build: <$module::$function as Callee>::callee,
            }
        }
    )*};
}

casts! {
    bool => u128: unsigned of_bool;
    i8 => u128: unsigned of_i8;
    i16 => u128: unsigned of_i16;
    i32 => u128: unsigned of_i32;
    i64 => u128: unsigned of_i64;
    isize => u128: unsigned of_isize;
    u8 => u128: unsigned of_u8;
    u16 => u128: unsigned of_u16;
    u32 => u128: unsigned of_u32;
    u64 => u128: unsigned of_u64;
    usize => u128: unsigned of_usize;
    f32 => u128: unsigned of_f32;
    f64 => u128: unsigned of_f64;
    u128 => i8: unsigned to_i8;
    u128 => i16: unsigned to_i16;
    u128 => i32: unsigned to_i32;
    u128 => i64: unsigned to_i64;
    u128 => isize: unsigned to_isize;
    u128 => u8: unsigned to_u8;
    u128 => u16: unsigned to_u16;
    u128 => u32: unsigned to_u32;
    u128 => u64: unsigned to_u64;
    u128 => usize: unsigned to_usize;
    u128 => f32: unsigned to_f32;
    u128 => f64: unsigned to_f64;
    bool => i128: signed of_bool;
    i8 => i128: signed of_i8;
    i16 => i128: signed of_i16;
    i32 => i128: signed of_i32;
    i64 => i128: signed of_i64;
    isize => i128: signed of_isize;
    u8 => i128: signed of_u8;
    u16 => i128: signed of_u16;
    u32 => i128: signed of_u32;
    u64 => i128: signed of_u64;
    usize => i128: signed of_usize;
    f32 => i128: signed of_f32;
    f64 => i128: signed of_f64;
    i128 => i8: signed to_i8;
    i128 => i16: signed to_i16;
    i128 => i32: signed to_i32;
    i128 => i64: signed to_i64;
    i128 => isize: signed to_isize;
    i128 => u8: signed to_u8;
    i128 => u16: signed to_u16;
    i128 => u32: signed to_u32;
    i128 => u64: signed to_u64;
    i128 => usize: signed to_usize;
    i128 => f32: signed to_f32;
    i128 => f64: signed to_f64;
    u128 => i128: signed of_u128;
    i128 => u128: signed to_u128;
}

converts! {
    [] bool => u128: unsigned::of_bool;
    [] char => u128: unsigned::of_char;
    [] u8 => u128: unsigned::of_u8;
    [] u16 => u128: unsigned::of_u16;
    [] u32 => u128: unsigned::of_u32;
    [] u64 => u128: unsigned::of_u64;
    [] bool => i128: signed::of_bool;
    [] i8 => i128: signed::of_i8;
    [] i16 => i128: signed::of_i16;
    [] i32 => i128: signed::of_i32;
    [] i64 => i128: signed::of_i64;
    [] u8 => i128: signed::of_u8;
    [] u16 => i128: signed::of_u16;
    [] u32 => i128: signed::of_u32;
    [] u64 => i128: signed::of_u64;
}

macro_rules! tries {
    ($($from:ident => $to:ident: $module:ident $function:ident;)*) => {$(
        impl TryFromBuiltin<$from> for $to {
            type Marker = $module::$function;
            type Error = TryFromIntError;
        }
    )*};
}

tries! {
    u128 => i8: unsigned try_to_i8;
    u128 => i16: unsigned try_to_i16;
    u128 => i32: unsigned try_to_i32;
    u128 => i64: unsigned try_to_i64;
    u128 => isize: unsigned try_to_isize;
    u128 => u8: unsigned try_to_u8;
    u128 => u16: unsigned try_to_u16;
    u128 => u32: unsigned try_to_u32;
    u128 => u64: unsigned try_to_u64;
    u128 => usize: unsigned try_to_usize;
    i128 => i8: signed try_to_i8;
    i128 => i16: signed try_to_i16;
    i128 => i32: signed try_to_i32;
    i128 => i64: signed try_to_i64;
    i128 => isize: signed try_to_isize;
    i128 => u8: signed try_to_u8;
    i128 => u16: signed try_to_u16;
    i128 => u32: signed try_to_u32;
    i128 => u64: signed try_to_u64;
    i128 => usize: signed try_to_usize;
    i8 => u128: unsigned try_of_i8;
    i16 => u128: unsigned try_of_i16;
    i32 => u128: unsigned try_of_i32;
    i64 => u128: unsigned try_of_i64;
    isize => u128: unsigned try_of_isize;
    usize => u128: unsigned try_of_usize;
    isize => i128: signed try_of_isize;
    usize => i128: signed try_of_usize;
    u128 => i128: signed try_of_u128;
    i128 => u128: signed try_to_u128;
}

/// Replaces sums and products of widened numbers by functions of the numbers, which cannot overflow. So `a as u128 * b
/// as u128` is the product of `a` and `b`.
pub(super) fn of_words(
    cx: &mut Builder,
    tree: &mut tree::FunctionTree,
    witness: &mut Witness,
    operators: &mut [(u32, tree::Callee)],
) {
    for (at, callee) in operators {
        let tree::Callee::Function(path) = &*callee else { continue };
        let (signed, name) = match path.strip_prefix("bessemer::wide::") {
            Some(path) => match path.split_once("::") {
                Some((module, name)) => (module == "i128", name),
                None => continue,
            },
            None => continue,
        };
        type Function = fn(&mut Builder) -> tree::Callee;
        let functions: [Function; 2] = match (signed, name) {
            (false, "sum") => [unsigned::sum_of_halves::callee, unsigned::sum_of_words::callee],
            (false, "product") => {
                [unsigned::product_of_halves::callee, unsigned::product_of_words::callee]
            }
            (true, "sum") => [signed::sum_of_halves::callee, signed::sum_of_words::callee],
            (true, "difference") => {
                [signed::difference_of_halves::callee, signed::difference_of_words::callee]
            }
            (true, "product") => {
                [signed::product_of_halves::callee, signed::product_of_words::callee]
            }
            _ => continue,
        };
        let mut words = Words { at: *at, signed, witness, found: None };
        words.block(&mut tree.body);
        if let Some(int) = words.found {
            let [halves, words] = functions;
            *callee = if int.bits() == 32 { halves(cx) } else { words(cx) };
        }
    }
}

/// Visitor that narrows the operands of one operator, if all of them are widened numbers.
struct Words<'a> {
    /// Slot of the operator's value.
    at: u32,
    /// True if its value has a sign.
    signed: bool,
    witness: &'a mut Witness,
    /// Type of the operands before they are widened.
    found: Option<Int>,
}

impl VisitMut for Words<'_> {
    fn expr(&mut self, expr: &mut Expr) {
        if expr.slot == Some(self.at)
            && let ExprKind::Binary(_, left, right) = &mut expr.kind
            && let (Some(one), Some(other)) = (self.widened(left), self.widened(right))
        {
            let int = match (self.signed, self.bits(one).max(self.bits(other))) {
                (false, ..=32) => Int::U32,
                (false, _) => Int::U64,
                (true, ..=32) => Int::I32,
                // Widened from 64 bits without a sign, an operand may need more than a word.
                (true, 65..) => return walk_expr_mut(self, expr),
                (true, _) => Int::I64,
            };
            self.found = Some(int);
            self.narrow(left, (one, int));
            self.narrow(right, (other, int));
        }
        walk_expr_mut(self, expr);
    }
}

impl Words<'_> {
    /// Returns the number of bits of a type's values, with a sign if the operator's value has one.
    fn bits(&self, int: Int) -> u32 {
        int.bits() + u32::from(self.signed && !int.signed())
    }

    /// Returns the type from which an operand is widened; none for another operand.
    fn widened(&self, operand: &Expr) -> Option<Int> {
        let scalar = match &operand.kind {
            ExprKind::Int(digits, None) => {
                let value = match digits.strip_prefix("0x") {
                    Some(digits) => u64::from_str_radix(digits, 16),
                    None => digits.parse(),
                };
                let value = value.ok()?;
                let ints = [(Int::U16, 16), (Int::U32, 32), (Int::U64, 64)];
                return ints.into_iter().find(|(_, bits)| value >> (bits - 1) <= 1).map(|it| it.0);
            }
            ExprKind::Cast(number) => match number.slot {
                None => return self.widened(number),
                Some(slot) => match self.witness.slots.get(slot as usize)? {
                    Ty::Scalar(scalar) => *scalar,
                    _ => return None,
                },
            },
            ExprKind::Call(callee, _) => match self.witness.callees.get(*callee as usize)? {
                tree::Callee::Function(path) => {
                    let of = path.strip_prefix("bessemer::wide::")?.split_once("::of_")?;
                    Scalar::from_name(of.1)?
                }
                tree::Callee::Builtin(_) => return None,
            },
            _ => return None,
        };
        match scalar {
            Scalar::Int(int) if self.signed || !int.signed() => Some(int),
            _ => None,
        }
    }

    /// Makes an operand that is widened from a type one of another type.
    fn narrow(&mut self, operand: &mut Expr, (from, to): (Int, Int)) {
        let site = operand.site;
        let kind = core::mem::replace(&mut operand.kind, ExprKind::Bool(false));
        let number = match kind {
            ExprKind::Cast(number) => Some(*number),
            ExprKind::Call(_, mut arguments) => arguments.pop(),
            literal => {
                *operand = Expr::plain(literal, site);
                return;
            }
        };
        if let Some(number) = number {
            if from == to && !number.is_unsuffixed() {
                *operand = number;
                return;
            }
            let slot = Some(self.witness.slots.len() as u32);
            *operand = Expr { kind: ExprKind::Cast(Box::new(number)), site, slot };
            self.witness.slots.push(Ty::Scalar(Scalar::Int(to)));
        }
    }
}
