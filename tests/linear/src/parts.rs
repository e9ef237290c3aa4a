//! Parts of matrices, and products that add to what is there.

macro_rules! sizes {
    ($($module:ident: $real:ident $n:tt;)*) => {
        $(pub mod $module {
            use bessemer::prelude::*;

            cases! {
                sum(a: [&] [SMatrix<$real, $n, 5>]) -> [$real] { a.sum() }
                mean(a: [&] [SMatrix<$real, $n, 5>]) -> [$real] { a.mean() }
                solve(
                    a: [&] [SMatrix<$real, $n, $n>], b: [&] [SMatrix<$real, $n, 2>]
                ) -> [SMatrix<$real, $n, 2>] {
                    if let Some(x) = bessemer::solve(a, b) { x } else { *b }
                }
                inverse(a: [&] [SMatrix<$real, $n, $n>]) -> [SMatrix<$real, $n, $n>] {
                    bessemer::inverse(a).unwrap_or(*a)
                }
                try_inverse(a: [&] [SMatrix<$real, $n, $n>]) -> [SMatrix<$real, $n, $n>] {
                    a.try_inverse().unwrap_or(*a)
                }
                trace(a: [&] [SMatrix<$real, $n, $n>]) -> [$real] { a.trace() }
                amax(a: [&] [SMatrix<$real, $n, 5>]) -> [$real] { a.amax() }
                amin(a: [&] [SMatrix<$real, $n, 5>]) -> [$real] { a.amin() }
                normalize(a: [&] [SMatrix<$real, $n, 2>]) -> [SMatrix<$real, $n, 2>] { a.normalize() }
                normalize_in_place(a: [&mut] [SMatrix<$real, $n, 1>]) -> [$real] { a.normalize_mut() }
                lower(a: [&] [SMatrix<$real, $n, 5>]) -> [SMatrix<$real, $n, 5>] {
                    a.lower_triangle()
                }
                upper(a: [&] [SMatrix<$real, $n, 5>]) -> [SMatrix<$real, $n, 5>] {
                    a.upper_triangle()
                }
                diagonal(a: [&] [SMatrix<$real, $n, $n>]) -> [SVector<$real, $n>] { a.diagonal() }
                from_diagonal(a: [&] [SVector<$real, $n>]) -> [SMatrix<$real, $n, $n>] {
                    SMatrix::<$real, $n, $n>::from_diagonal(a)
                }
                scaled(a: [&] [SMatrix<$real, $n, 2>], by: [&] [$real]) -> [SMatrix<$real, $n, 2>] {
                    a.scale(*by).unscale(3.0)
                }
                ad_mul(
                    a: [&] [SMatrix<$real, $n, 4>], b: [&] [SMatrix<$real, $n, 2>]
                ) -> [SMatrix<$real, 4, 2>] { a.ad_mul(b) }
                adjoint(a: [&] [SMatrix<$real, $n, 2>]) -> [SMatrix<$real, 2, $n>] { a.adjoint() }
                gemm(
                    y: [&mut] [SMatrix<$real, 4, 2>], alpha: [&] [$real], a: [&] [SMatrix<$real, 4, $n>],
                    b: [&] [SMatrix<$real, $n, 2>], beta: [&] [$real]
                ) -> [bool] {
                    y.gemm(*alpha, a, b, *beta);
                    true
                }
                gemm_anew(
                    y: [&mut] [SMatrix<$real, 4, 2>], a: [&] [SMatrix<$real, 4, $n>],
                    b: [&] [SMatrix<$real, $n, 2>]
                ) -> [bool] {
                    y.gemm(0.5, a, b, 0.0);
                    true
                }
                gemv(
                    y: [&mut] [SVector<$real, 4>], alpha: [&] [$real], a: [&] [SMatrix<$real, 4, $n>],
                    x: [&] [SVector<$real, $n>], beta: [&] [$real]
                ) -> [bool] {
                    y.gemv(*alpha, a, x, *beta);
                    true
                }
                ger(
                    a: [&mut] [SMatrix<$real, $n, 2>], alpha: [&] [$real], x: [&] [SVector<$real, $n>],
                    y: [&] [SVector<$real, 2>], beta: [&] [$real]
                ) -> [bool] {
                    a.ger(*alpha, x, y, *beta);
                    true
                }
                axpy(
                    y: [&mut] [SVector<$real, $n>], alpha: [&] [$real], x: [&] [SVector<$real, $n>],
                    beta: [&] [$real]
                ) -> [bool] {
                    y.axpy(*alpha, x, *beta);
                    true
                }
            }
        })*
    };
}

sizes! {
    f64_3: f64 3; f32_9: f32 9;
}
