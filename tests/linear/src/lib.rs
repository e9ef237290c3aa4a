//! One function for each routine of linear algebra, each type and each size.
//!
//! The table of routines (`tests/tests/linear.rs`) calls every one natively, in the interpreter and as C.
//! A function that is added here is compared from then on.

#![no_std]
#![allow(missing_docs, clippy::all)]

/// Gives words, one after another.
pub type Get<'a> = &'a mut dyn FnMut() -> u64;
/// Takes words, one after another.
pub type Put<'a> = &'a mut dyn FnMut(u64);

/// A function of the table.
pub struct Case {
    /// The path of its module.
    pub module: &'static str,
    /// Its name.
    pub name: &'static str,
    /// Takes the words of the arguments; gives those of the result, and of what it changed.
    pub run: fn(Get<'_>, Put<'_>),
}

/// Functions with their cases. An argument is `[&]` or `[&mut]` to what its type says.
macro_rules! cases {
    ($($name:ident($($argument:ident: [$($kind:tt)+] [$($ty:tt)+]),*) -> [$($result:tt)+] $body:block)*) => {
        $(
            #[bessemer::function]
            pub fn $name($($argument: $($kind)+ $($ty)+),*) -> $($result)+ $body
        )*

        bessemer::__natively! {
            pub const CASES: &[crate::Case] = &[$(crate::Case {
                module: module_path!(),
                name: stringify!($name),
                run: |get, put| {
                    $(#[allow(unused_mut)]
                    let mut $argument = <$($ty)+ as bessemer::Plain>::load(get);)*
                    let result = $name($($($kind)+ $argument),*);
                    bessemer::Plain::store(&result, put);
                    $(changed!([$($kind)+] $argument put);)*
                },
            }),*];
        }
    };
}

macro_rules! changed {
    ([&mut] $argument:ident $put:ident) => {
        bessemer::Plain::store(&$argument, $put)
    };
    ([&] $argument:ident $put:ident) => {};
}

macro_rules! sizes {
    ($list:ident, $docs:literal: $($module:ident: $real:ident $n:tt;)*) => {
        $(pub mod $module {
            use bessemer::linear::kernels;
            use bessemer::prelude::*;

            cases! {
                solve(
                    a: [&mut] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 1>]
                ) -> [bool] { bessemer::solve_mut(a, b) }
                solve_into(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 1>]
                ) -> [bool] { bessemer::solve_into(a, b) }
                solve_for_three(
                    a: [&mut] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 3>]
                ) -> [bool] { bessemer::solve_mut(a, b) }
                inverse(a: [&mut] [SMatrix<$real, $n, $n>]) -> [bool] {
                    bessemer::inverse_mut(a)
                }
                determinant(a: [&] [SMatrix<$real, $n, $n>]) -> [$real] { a.determinant() }
                cholesky(a: [&mut] [SMatrix<$real, $n, $n>]) -> [bool] { kernels::cholesky_mut(a) }
                cholesky_lower(a: [&] [SMatrix<$real, $n, $n>]) -> [SMatrix<$real, $n, $n>] { kernels::cholesky_lower(a) }
                cholesky_solve(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 2>]
                ) -> [bool] {
                    kernels::cholesky_solve_mut(a, b);
                    true
                }
                solve_lower(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 2>]
                ) -> [bool] { kernels::solve_lower_mut(a, b) }
                solve_upper(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 1>]
                ) -> [bool] { kernels::solve_upper_mut(a, b) }
                tr_solve_lower(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 2>]
                ) -> [bool] { kernels::tr_solve_lower_mut(a, b) }
                tr_solve_upper(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 1>]
                ) -> [bool] { kernels::tr_solve_upper_mut(a, b) }
                product(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&] [SMatrix<$real, $n, $n>]
                ) -> [SMatrix<$real, $n, $n>] { a * b }
                product_with_vector(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&] [SMatrix<$real, $n, 1>]
                ) -> [SMatrix<$real, $n, 1>] { a * b }
                product_of_oblongs(
                    a: [&] [SMatrix<$real, 3, $n>], b: [&] [SMatrix<$real, $n, 5>]
                ) -> [SMatrix<$real, 3, 5>] { a * b }
                outer_product(
                    a: [&] [SMatrix<$real, $n, 1>], b: [&] [SMatrix<$real, 1, 7>]
                ) -> [SMatrix<$real, $n, 7>] { a * b }
                product_tr(
                    a: [&] [SMatrix<$real, 4, $n>], b: [&] [SMatrix<$real, $n, $n>]
                ) -> [SMatrix<$real, 4, $n>] { a * b.transpose() }
                tr_product(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&] [SMatrix<$real, $n, 5>]
                ) -> [SMatrix<$real, $n, 5>] { a.transpose() * b }
                congruence(
                    a: [&] [SMatrix<$real, $n, $n>], p: [&] [SMatrix<$real, $n, $n>]
                ) -> [SMatrix<$real, $n, $n>] { a * p * a.transpose() }
                tr_mul(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&] [SMatrix<$real, $n, 4>]
                ) -> [SMatrix<$real, $n, 4>] { a.tr_mul(b) }
            }
        })*

        bessemer::__natively! {
            #[doc = $docs]
            pub const $list: &[&[Case]] = &[$($module::CASES,)*];
        }
    };
}

sizes! {
    SIZES, "Sizes at which most is different.":
    f64_1: f64 1; f64_3: f64 3; f64_4: f64 4; f64_6: f64 6; f64_9: f64 9; f64_13: f64 13;
    f64_20: f64 20;
    f32_4: f32 4; f32_9: f32 9;
}

sizes! {
    OTHER_SIZES, "The other sizes up to 20, each in both types.":
    f64_2: f64 2; f64_5: f64 5; f64_7: f64 7; f64_8: f64 8; f64_10: f64 10; f64_11: f64 11; f64_12: f64 12; f64_14: f64 14; f64_15: f64 15;
    f64_16: f64 16; f64_17: f64 17; f64_18: f64 18; f64_19: f64 19;
    f32_1: f32 1; f32_2: f32 2; f32_3: f32 3; f32_5: f32 5; f32_6: f32 6; f32_7: f32 7; f32_8: f32 8; f32_10: f32 10; f32_11: f32 11; f32_12: f32 12;
    f32_13: f32 13; f32_14: f32 14; f32_15: f32 15; f32_16: f32 16; f32_17: f32 17; f32_18: f32 18;
    f32_19: f32 19; f32_20: f32 20;
}

/// Sizes at which kernels change their ways, and those beyond what is written out.
pub mod borders;

/// Functions of nalgebra for parts of matrices and for products that add; a few sizes are enough.
pub mod parts;

/// Decompositions as values.
pub mod factored;

/// Every other method of matrices.
pub mod methods;

bessemer::__natively! {
    /// Every function but those of [`OTHER_SIZES`].
    pub const CASES: [&[&[Case]]; 3] = [
        SIZES,
        borders::CASES,
        &[
            parts::f64_3::CASES,
            parts::f32_9::CASES,
            methods::f64_3x4::CASES,
            methods::f32_5x2::CASES,
            factored::f64_1::CASES,
            factored::f64_3::CASES,
            factored::f64_6::CASES,
            factored::f64_2::CASES,
            factored::f32_9::CASES,
        ],
    ];
}
