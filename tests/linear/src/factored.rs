//! Decompositions as values, and systems with triangular matrices.

macro_rules! sizes {
    ($($module:ident: $real:ident $n:tt $r:tt;)*) => {
        $(pub mod $module {
            use bessemer::nalgebra::{Cholesky, LU};
            use bessemer::prelude::*;

            type Square = SMatrix<$real, $n, $n>;
            type Right = SMatrix<$real, $n, 2>;
            type Tall = SMatrix<$real, $r, $n>;

            cases! {
                lu_solve(a: [&] [Square], b: [&] [Right]) -> [Option<Right>] { a.lu().solve(b) }
                lu_twice(a: [&] [Square], b: [&] [Right], c: [&mut] [Right]) -> [(Option<Right>, bool)] {
                    let lu = LU::new(*a);
                    let first = lu.solve(b);
                    (first, lu.solve_mut(c))
                }
                lu_inverse(a: [&] [Square]) -> [Option<Square>] { a.lu().try_inverse() }
                lu_facts(a: [&] [Square]) -> [($real, bool, Square, Square)] {
                    let lu = a.lu();
                    (lu.determinant(), lu.is_invertible(), lu.l(), lu.u())
                }
                cholesky_solve(a: [&] [Square], b: [&] [Right], c: [&mut] [Right]) -> [Option<Right>] {
                    let factor = Cholesky::new(*a)?;
                    factor.solve_mut(c);
                    Some(factor.solve(b))
                }
                cholesky_facts(a: [&] [Square]) -> [Option<(Square, $real, Square)>] {
                    if let Some(factor) = a.cholesky() {
                        Some((factor.inverse(), factor.determinant(), factor.l()))
                    } else {
                        None
                    }
                }
                cholesky_update(a: [&] [Square], x: [&] [SVector<$real, $n>], s: [&] [$real]) -> [Option<Square>] {
                    let mut factor = a.cholesky()?;
                    factor.rank_one_update(x, *s);
                    Some(factor.unpack_dirty())
                }
                qr_parts(a: [&] [Tall]) -> [(Tall, Square)] {
                    let qr = a.qr();
                    (qr.q(), qr.r())
                }
                qr_least_squares(a: [&] [Tall], b: [&mut] [SMatrix<$real, $r, 1>]) -> [Square] {
                    let qr = a.qr();
                    qr.q_tr_mul(b);
                    qr.unpack_r()
                }
                qr_solve(a: [&] [Square], b: [&] [Right], c: [&mut] [Right]) -> [(Option<Right>, bool)] {
                    let qr = a.qr();
                    (qr.solve(b), qr.solve_mut(c))
                }
                qr_inverse(a: [&] [Square]) -> [(Option<Square>, bool)] {
                    let qr = a.qr();
                    (qr.try_inverse(), qr.is_invertible())
                }
                udu(a: [&] [Square]) -> [Option<(Square, SVector<$real, $n>, Square)>] {
                    let udu = a.udu()?;
                    Some((udu.u, udu.d, udu.d_matrix()))
                }
                triangular(a: [&] [Square], b: [&] [Right]) -> [[Option<Right>; 4]] {
                    [
                        a.solve_lower_triangular(b),
                        a.solve_upper_triangular(b),
                        a.tr_solve_lower_triangular(b),
                        a.ad_solve_upper_triangular(b),
                    ]
                }
                triangular_mut(a: [&] [Square], b: [&mut] [Right], c: [&mut] [Right]) -> [(bool, bool)] {
                    (a.solve_lower_triangular_mut(b), a.solve_upper_triangular_mut(c))
                }
            }
        })*
    };
}

sizes! {
    f64_1: f64 1 2; f64_2: f64 2 17; f64_3: f64 3 3; f64_6: f64 6 9; f32_9: f32 9 9;
}
