//! Operators, conversions and methods of integers of 128 bits.
//!
//! An operator is found by the types in its slots. `as` has no expression that rustc could look up, so its functions are
//! in the registry of conversions, under the name [`tree::AS`].

#![allow(missing_docs)]

use alloc::boxed::Box;

use bessemer_tree as tree;
use bessemer_tree::number::{Int, Scalar};
use bessemer_tree::visit::{VisitMut, walk_expr_mut};
use bessemer_tree::{Expr, ExprKind, Ty};

use super::builder::{Builder, Callee, OwnOperator, Witness};
use super::comparison::Extremes;
use super::numbers::{FromBuiltin, OrderBuiltins, converts};
use super::slot::{DslType, Seen, dsl_types};
use crate::wide::u128 as unsigned;

/// Path of the type in the C.
const UNSIGNED: &str = "bessemer::wide::u128::U128";

dsl_types! {
    [] [] u128 as Self => |cx| unsigned::U128::ty(cx);
}

/// Returns true for an integer of 128 bits.
fn is_wide(ty: &Ty) -> bool {
    matches!(ty, Ty::Named(path) if path == UNSIGNED)
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
    if !is_wide(slots.get(operator.at as usize)?) {
        return None;
    }
    // A literal has no slot.
    let right = operator.operands.get(1).copied().flatten();
    let right = right.and_then(|slot| slots.get(slot as usize));
    match operator.of.trim_end_matches("Assign") {
        "Add" => of::<unsigned::sum>(cx),
        "Sub" => of::<unsigned::difference>(cx),
        "Mul" => of::<unsigned::product>(cx),
        "Div" => of::<unsigned::div>(cx),
        "Rem" => of::<unsigned::rem>(cx),
        "BitAnd" => of::<unsigned::both>(cx),
        "BitOr" => of::<unsigned::either>(cx),
        "BitXor" => of::<unsigned::differing>(cx),
        "Not" => of::<unsigned::opposite>(cx),
        "Shl" => shifts::<true>(cx, right),
        "Shr" => shifts::<false>(cx, right),
        _ => None,
    }
}

macro_rules! shifts {
    ($($int:ident $up:ident $down:ident;)*) => {
        /// Returns the function that shifts, up or down, by a number of this type.
        fn shifts<const UP: bool>(cx: &mut Builder, by: Option<&Ty>) -> Option<tree::Callee> {
            match (by, UP) {
                $(
                    (Some(Ty::Scalar(Scalar::Int(Int::$int))), true) => of::<unsigned::$up>(cx),
                    (Some(Ty::Scalar(Scalar::Int(Int::$int))), false) => of::<unsigned::$down>(cx),
                )*
                (_, true) => of::<unsigned::shl_u32>(cx),
                (_, false) => of::<unsigned::shr_u32>(cx),
            }
        }
    };
}

shifts! {
    I8 shl_i8 shr_i8;
    I16 shl_i16 shr_i16;
    I32 shl_i32 shr_i32;
    I64 shl_i64 shr_i64;
    Isize shl_isize shr_isize;
    U8 shl_u8 shr_u8;
    U16 shl_u16 shr_u16;
    U64 shl_u64 shr_u64;
    Usize shl_usize shr_usize;
}

macro_rules! casts {
    ($($from:ident => $to:ident: $function:ident;)*) => {$(
        super::register! {
            OwnOperator {
                name: tree::AS,
                left: <$to as DslType>::ty,
                right: <$from as DslType>::ty,
                build: <unsigned::$function as Callee>::callee,
            }
        }
    )*};
}

casts! {
    bool => u128: of_bool;
    i8 => u128: of_i8;
    i16 => u128: of_i16;
    i32 => u128: of_i32;
    i64 => u128: of_i64;
    isize => u128: of_isize;
    u8 => u128: of_u8;
    u16 => u128: of_u16;
    u32 => u128: of_u32;
    u64 => u128: of_u64;
    usize => u128: of_usize;
    u128 => i8: to_i8;
    u128 => i16: to_i16;
    u128 => i32: to_i32;
    u128 => i64: to_i64;
    u128 => isize: to_isize;
    u128 => u8: to_u8;
    u128 => u16: to_u16;
    u128 => u32: to_u32;
    u128 => u64: to_u64;
    u128 => usize: to_usize;
}

impl OrderBuiltins for u128 {
    type Min = <u128 as Extremes>::Min;
    type Max = <u128 as Extremes>::Max;
    type Clamp = <u128 as Extremes>::Clamp;
}

converts! {
    [] bool => u128: unsigned::of_bool;
    [] char => u128: unsigned::of_char;
    [] u8 => u128: unsigned::of_u8;
    [] u16 => u128: unsigned::of_u16;
    [] u32 => u128: unsigned::of_u32;
    [] u64 => u128: unsigned::of_u64;
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
        let functions = match callee {
            tree::Callee::Function(path) if path == "bessemer::wide::u128::sum" => {
                [unsigned::sum_of_halves::callee, unsigned::sum_of_words::callee]
            }
            tree::Callee::Function(path) if path == "bessemer::wide::u128::product" => {
                [unsigned::product_of_halves::callee, unsigned::product_of_words::callee]
            }
            _ => continue,
        };
        let mut words = Words { at: *at, witness, found: None };
        words.block(&mut tree.body);
        if let Some(int) = words.found {
            let [halves, words] = functions;
            *callee = if int == Int::U32 { halves(cx) } else { words(cx) };
        }
    }
}

/// Visitor that narrows the operands of one operator, if all of them are widened numbers.
struct Words<'a> {
    /// Slot of the operator's value.
    at: u32,
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
            let int = if one.bits().max(other.bits()) > 32 { Int::U64 } else { Int::U32 };
            self.found = Some(int);
            self.narrow(left, (one, int));
            self.narrow(right, (other, int));
        }
        walk_expr_mut(self, expr);
    }
}

impl Words<'_> {
    /// Returns the unsigned type from which an operand is widened; none for another operand.
    fn widened(&self, operand: &Expr) -> Option<Int> {
        let scalar = match &operand.kind {
            ExprKind::Int(digits, None) => {
                let value = match digits.strip_prefix("0x") {
                    Some(digits) => u64::from_str_radix(digits, 16),
                    None => digits.parse(),
                };
                return Some(if value.ok()? <= u32::MAX.into() { Int::U32 } else { Int::U64 });
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
                    Scalar::from_name(path.strip_prefix("bessemer::wide::u128::of_")?)?
                }
                tree::Callee::Builtin(_) => return None,
            },
            _ => return None,
        };
        match scalar {
            Scalar::Int(int) if !int.signed() => Some(int),
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
