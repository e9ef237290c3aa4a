//! The operators of core's `Wrapping`.

use core::num::Wrapping;

use bessemer_tree::Ty;

use super::builder::Builder;
use super::operators::{Operates, sign};
use super::slot::{DslType, Seen, Value, dsl_types};
use crate::math::Integer;
use crate::wrapping;

dsl_types! {
    [T: Value] [T: Seen] Wrapping<T> as Wrapping<T::Slot> => |cx| wrapping::Wrapping::<T>::ty(cx);
}

macro_rules! operators {
    ($($sign:ident: $function:ident;)*) => {$(
        impl<T: Value + Integer> Operates<sign::$sign, Wrapping<T>> for Wrapping<T> {
            type Marker = wrapping::$function<T>;
        }
    )*};
}

operators! {
    Add: __function_sum;
    Sub: __function_difference;
    Mul: __function_product;
    Neg: __function_negative;
    BitAnd: __function_both;
    BitOr: __function_either;
    BitXor: __function_differing;
    AddAssign: __function_add;
    SubAssign: __function_subtract;
    MulAssign: __function_multiply;
    Div: __function_quotient;
    DivAssign: __function_divide;
    Not: __function_opposite;
    BitAndAssign: __function_keep;
    BitOrAssign: __function_set;
    BitXorAssign: __function_flip;
}

macro_rules! shifts {
    ($($sign:ident: $function:ident;)*) => {$(
        impl<T: Value + Integer> Operates<sign::$sign, usize> for Wrapping<T> {
            type Marker = wrapping::$function<T>;
        }
    )*};
}

shifts! {
    Shl: __function_up;
    Shr: __function_down;
    ShlAssign: __function_move_up;
    ShrAssign: __function_move_down;
}
