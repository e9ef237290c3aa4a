//! Sizes at which a kernel is cut up in another way: by fours and not, written out, in loops, in tiles.

macro_rules! sizes {
    ($($module:ident: $real:ident $n:tt;)*) => {
        $(pub mod $module {
            use bessemer::linear::kernels;
            use bessemer::prelude::*;

            cases! {
                solve_into(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 1>]
                ) -> [bool] { bessemer::solve_into(a, b) }
                solve_for_three(
                    a: [&mut] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 3>]
                ) -> [bool] { bessemer::solve_mut(a, b) }
                inverse(a: [&mut] [SMatrix<$real, $n, $n>]) -> [bool] {
                    bessemer::inverse_mut(a)
                }
                cholesky(a: [&mut] [SMatrix<$real, $n, $n>]) -> [bool] { kernels::cholesky_mut(a) }
                cholesky_lower(a: [&] [SMatrix<$real, $n, $n>]) -> [SMatrix<$real, $n, $n>] { kernels::cholesky_lower(a) }
                cholesky_solve(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&mut] [SMatrix<$real, $n, 1>]
                ) -> [bool] {
                    kernels::cholesky_solve_mut(a, b);
                    true
                }
                product(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&] [SMatrix<$real, $n, $n>]
                ) -> [SMatrix<$real, $n, $n>] { a * b }
            }
        })*

        bessemer::__natively! {
            pub(crate) const CASES: &[&[crate::Case]] = &[$($module::CASES,)*];
        }
    };
}

sizes! {
    f64_7: f64 7; f64_8: f64 8; f64_10: f64 10; f64_12: f64 12; f64_17: f64 17; f64_20: f64 20; f64_33: f64 33;
    f32_6: f32 6; f32_12: f32 12; f32_16: f32 16; f32_33: f32 33;
}
