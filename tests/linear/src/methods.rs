//! nalgebra's methods of matrices that are functions of the DSL in the C.

macro_rules! sizes {
    ($($module:ident: $real:ident $r:tt $c:tt;)*) => {
        $(pub mod $module {
            use bessemer::prelude::*;

            type M = SMatrix<$real, $r, $c>;
            type Square = SMatrix<$real, $r, $r>;
            type Column = SVector<$real, $r>;
            type Row = SMatrix<$real, 1, $c>;
            type Across = SVector<$real, $c>;

            cases! {
                largest(a: [&] [M]) -> [($real, $real)] { (a.max(), a.min()) }
                magnitudes(a: [&] [M]) -> [($real, $real)] { (a.camax(), a.camin()) }
                largest_at(a: [&] [M]) -> [(usize, usize)] { a.iamax_full() }
                bounds(a: [&] [M], b: [&] [M]) -> [(M, M)] { (a.inf(b), a.sup(b)) }
                both_bounds(a: [&] [M], b: [&] [M]) -> [(M, M)] { a.inf_sup(b) }
                absolute(a: [&] [M]) -> [M] { a.abs() }
                bounded_sum(a: [&] [M], b: [&] [M]) -> [M] { (a + b).sup(&-b).inf(a) }
                extremes_of_sums(a: [&] [M], b: [&] [M]) -> [($real, $real)] {
                    ((a - b).amax(), (a + b.abs() * 2.0).amin())
                }
                largest_of_transposed(a: [&] [Square]) -> [$real] { (a + a.transpose()).amax() }
                places(v: [&] [Column]) -> [((usize, $real), (usize, $real))] { (v.argmax(), v.argmin()) }
                indices(v: [&] [Column]) -> [(usize, usize, usize, usize, usize)] {
                    (v.imax(), v.imin(), v.iamax(), v.icamax(), v.iamin())
                }
                product(a: [&] [M]) -> [$real] { a.product() }
                variance(a: [&] [M]) -> [$real] { a.variance() }
                row_sum(a: [&] [M]) -> [(Row, Across)] { (a.row_sum(), a.row_sum_tr()) }
                column_sum(a: [&] [M]) -> [Column] { a.column_sum() }
                row_product(a: [&] [M]) -> [(Row, Across)] { (a.row_product(), a.row_product_tr()) }
                column_product(a: [&] [M]) -> [Column] { a.column_product() }
                row_mean(a: [&] [M]) -> [(Row, Across)] { (a.row_mean(), a.row_mean_tr()) }
                column_mean(a: [&] [M]) -> [Column] { a.column_mean() }
                row_variance(a: [&] [M]) -> [(Row, Across)] { (a.row_variance(), a.row_variance_tr()) }
                column_variance(a: [&] [M]) -> [Column] { a.column_variance() }
                lp_norm(a: [&] [M]) -> [$real] { a.lp_norm(3) }
                norms(a: [&] [M]) -> [($real, $real, $real)] {
                    (a.one_norm(), a.magnitude(), a.magnitude_squared())
                }
                distance(a: [&] [M], b: [&] [M]) -> [$real] { a.metric_distance(b) }
                try_normalize(a: [&] [M], least: [&] [$real]) -> [Option<M>] {
                    a.try_normalize(*least)
                }
                try_normalize_mut(a: [&mut] [M], least: [&] [$real]) -> [Option<$real>] {
                    a.try_normalize_mut(*least)
                }
                set_magnitude(a: [&mut] [M], to: [&] [$real]) -> [bool] {
                    a.set_magnitude(*to);
                    true
                }
                try_set_magnitude(a: [&mut] [M], to: [&] [$real], least: [&] [$real]) -> [bool] {
                    a.try_set_magnitude(*to, *least);
                    true
                }
                cap_magnitude(a: [&] [M], most: [&] [$real]) -> [M] { a.cap_magnitude(*most) }
                is_identity(a: [&] [M], near: [&] [$real]) -> [(bool, bool)] {
                    (a.is_identity(*near), (a - a + M::identity()).is_identity(0.0))
                }
                is_orthogonal(a: [&] [Square], near: [&] [$real]) -> [(bool, bool, bool)] {
                    (a.is_orthogonal(*near), a.is_special_orthogonal(2.0), a.is_invertible())
                }
                add_scalar(a: [&mut] [M], b: [&] [$real]) -> [M] {
                    let sum = a.add_scalar(*b);
                    a.add_scalar_mut(*b);
                    sum
                }
                scaled_in_place(a: [&mut] [M], b: [&] [$real]) -> [bool] {
                    a.neg_mut();
                    a.scale_mut(*b);
                    a.unscale_mut(3.0);
                    true
                }
                component_assign(a: [&mut] [M], b: [&] [M], c: [&mut] [M]) -> [bool] {
                    a.component_mul_assign(b);
                    c.component_div_assign(b);
                    true
                }
                cmpy(
                    y: [&mut] [M], alpha: [&] [$real], a: [&] [M], b: [&] [M], beta: [&] [$real]
                ) -> [bool] {
                    y.cmpy(*alpha, a, b, *beta);
                    true
                }
                cdpy(
                    y: [&mut] [M], alpha: [&] [$real], a: [&] [M], b: [&] [M], beta: [&] [$real]
                ) -> [bool] {
                    y.cdpy(*alpha, a, b, *beta);
                    true
                }
                cmpy_anew(y: [&mut] [M], a: [&] [M], b: [&] [M]) -> [bool] {
                    y.cmpy(0.5, a, b, 0.0);
                    true
                }
                lerp(a: [&] [Column], b: [&] [Column], t: [&] [$real]) -> [(Column, Column)] {
                    (a.lerp(b, *t), a.lerp(b, 1.0))
                }
                fill(a: [&mut] [M], b: [&mut] [M], value: [&] [$real]) -> [bool] {
                    a.fill(*value);
                    b.fill_diagonal(*value);
                    true
                }
                fill_line(a: [&mut] [M], at: [&] [usize], b: [&mut] [M], value: [&] [$real]) -> [bool] {
                    a.fill_row(*at, *value);
                    b.fill_column(*at, *value);
                    true
                }
                fill_with_identity(a: [&mut] [M]) -> [bool] {
                    a.fill_with_identity();
                    true
                }
                fill_triangle(a: [&mut] [M], b: [&mut] [M], value: [&] [$real]) -> [bool] {
                    a.fill_lower_triangle(*value, 1);
                    b.fill_upper_triangle(*value, 2);
                    true
                }
                fill_triangles(a: [&mut] [M], shift: [&] [usize], value: [&] [$real]) -> [bool] {
                    a.fill_upper_triangle(*value, *shift);
                    a.fill_lower_triangle(2.0, *shift);
                    true
                }
                mirror(a: [&mut] [Square], b: [&mut] [Square]) -> [bool] {
                    a.fill_lower_triangle_with_upper_triangle();
                    b.fill_upper_triangle_with_lower_triangle();
                    true
                }
                exchange(a: [&mut] [M], one: [&] [usize], other: [&] [usize]) -> [bool] {
                    a.swap((*one, 0), (1, *other));
                    a.swap_rows(*one, *other);
                    a.swap_columns(*other, *one);
                    true
                }
                copies(a: [&mut] [M], b: [&] [M], c: [&mut] [Square], d: [&] [Square]) -> [bool] {
                    a.copy_from(b);
                    c.tr_copy_from(d);
                    true
                }
                transposed(a: [&mut] [SMatrix<$real, $c, $r>], b: [&] [M], c: [&mut] [Square]) -> [bool] {
                    b.transpose_to(a);
                    c.transpose_mut();
                    true
                }
                set_diagonal(a: [&mut] [Square], d: [&] [Column]) -> [bool] {
                    a.set_diagonal(d);
                    true
                }
                from_diagonal_element(value: [&] [$real]) -> [M] { M::from_diagonal_element(*value) }
                ith(at: [&] [usize], value: [&] [$real]) -> [Column] { Column::ith(*at, *value) }
                from_slices(list: [&] [[$real; 12]]) -> [(SMatrix<$real, 3, 4>, SMatrix<$real, 3, 4>)] {
                    (SMatrix::from_row_slice(list), SMatrix::from_column_slice(list))
                }
                from_columns(a: [&] [Column], b: [&] [Column]) -> [SMatrix<$real, $r, 3>] {
                    SMatrix::from_columns(&[*a, *b, *a])
                }
                from_rows(a: [&] [Row], b: [&] [Row]) -> [SMatrix<$real, 2, $c>] {
                    SMatrix::from_rows(&[*a, *b])
                }
                symmetric_part(a: [&] [Square]) -> [Square] { a.symmetric_part() }
                powers(a: [&] [Square], n: [&] [u32]) -> [(Square, Square, Square)] {
                    (a.pow(*n), a.pow(5), a.pow(6))
                }
                kronecker(a: [&] [SMatrix<$real, 2, 3>], b: [&] [M]) -> [bool] {
                    let product = a.kronecker(b);
                    product.nrows() == 2 * b.nrows() && product.ncols() == 3 * b.ncols()
                }
                kronecker_elements(
                    a: [&] [SMatrix<$real, 2, 3>], b: [&] [SMatrix<$real, 3, 2>]
                ) -> [SMatrix<$real, 6, 6>] { a.kronecker(b) }
                pushed(a: [&] [SVector<$real, 4>], b: [&] [$real]) -> [SVector<$real, 5>] { a.push(*b) }
                inserted(a: [&] [SMatrix<$real, 2, 3>], at: [&] [usize], b: [&] [$real])
                    -> [(SMatrix<$real, 3, 3>, SMatrix<$real, 2, 4>)]
                {
                    (a.insert_row(*at, *b), a.insert_column(*at + 2, *b))
                }
                removed(a: [&] [SMatrix<$real, 2, 3>], at: [&] [usize])
                    -> [(SMatrix<$real, 1, 3>, SMatrix<$real, 2, 2>)]
                {
                    (a.remove_row(*at), a.remove_column(*at + 1))
                }
                resized(a: [&] [SMatrix<$real, 2, 3>], b: [&] [$real])
                    -> [(SMatrix<$real, 1, 5>, SMatrix<$real, 4, 2>)]
                {
                    (a.fixed_resize::<1, 5>(*b), a.fixed_resize::<4, 2>(*b))
                }
                cross_matrix(v: [&] [SVector<$real, 3>]) -> [SMatrix<$real, 3, 3>] { v.cross_matrix() }
                gemv_tr(
                    y: [&mut] [Across], alpha: [&] [$real], a: [&] [M], x: [&] [Column], beta: [&] [$real]
                ) -> [bool] {
                    y.gemv_tr(*alpha, a, x, *beta);
                    true
                }
                gemm_tr(
                    y: [&mut] [SMatrix<$real, $c, 2>], alpha: [&] [$real], a: [&] [M],
                    b: [&] [SMatrix<$real, $r, 2>], beta: [&] [$real]
                ) -> [bool] {
                    y.gemm_tr(*alpha, a, b, *beta);
                    true
                }
                gemm_tr_anew(
                    y: [&mut] [SMatrix<$real, $c, 2>], a: [&] [M], b: [&] [SMatrix<$real, $r, 2>]
                ) -> [bool] {
                    y.gemm_tr(0.5, a, b, 0.0);
                    true
                }
                axcpy(
                    y: [&mut] [Column], alpha: [&] [$real], x: [&] [Column], c: [&] [$real],
                    beta: [&] [$real]
                ) -> [bool] {
                    y.axcpy(*alpha, x, *c, *beta);
                    true
                }
                syger(
                    a: [&mut] [Square], alpha: [&] [$real], x: [&] [Column], y: [&] [Column],
                    beta: [&] [$real]
                ) -> [bool] {
                    a.syger(*alpha, x, y, *beta);
                    true
                }
                tr_dot(a: [&] [M], b: [&] [SMatrix<$real, $c, $r>]) -> [$real] { a.tr_dot(b) }
                quadform(
                    y: [&mut] [SMatrix<$real, $c, $c>], alpha: [&] [$real], mid: [&] [Square],
                    right: [&] [M], beta: [&] [$real]
                ) -> [bool] {
                    y.quadform(*alpha, mid, right, *beta);
                    true
                }
                quadform_tr(
                    y: [&mut] [Square], alpha: [&] [$real], left: [&] [M],
                    mid: [&] [SMatrix<$real, $c, $c>], beta: [&] [$real]
                ) -> [bool] {
                    y.quadform_tr(*alpha, left, mid, *beta);
                    true
                }
                quadform_tr_anew(
                    y: [&mut] [Square], left: [&] [M], mid: [&] [SMatrix<$real, $c, $c>]
                ) -> [bool] {
                    y.quadform_tr(0.5, left, mid, 0.0);
                    true
                }
            }
        })*
    };
}

sizes! {
    f64_3x4: f64 3 4; f32_5x2: f32 5 2;
}
