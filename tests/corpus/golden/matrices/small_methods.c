/* The C of tests/corpus/src/programs/matrices/small_methods.rs. Written by a test. */

/* small_methods.c */

void small_methods_quadratic(const double v[3], const double a[9],
    triple_f64_f64_f64_t *BESSEMER_RESTRICT result)
{
    const double row[3] = {
        v[0] * a[0 + 3 * 0] + v[1] * a[1 + 3 * 0] + v[2] * a[2 + 3 * 0],
        v[0] * a[0 + 3 * 1] + v[1] * a[1 + 3 * 1] + v[2] * a[2 + 3 * 1],
        v[0] * a[0 + 3 * 2] + v[1] * a[1 + 3 * 2] + v[2] * a[2 + 3 * 2]
    };
    const double vector[1] = {row[0] * v[0] + row[1] * v[1] + row[2] * v[2]};
    const double result_a[1] = {row[0] * v[0] + row[1] * v[1] + row[2] * v[2]};
    const double result_a_2[1] = {row[0] * v[0] + row[1] * v[1] + row[2] * v[2]};
    result->first = parts_to_scalar_f64(result_a);
    result->second = parts_to_scalar_f64(result_a_2) + vector[0];
    result->third = row[0] - row[2];
}

float small_methods_turn(const float a[2], const float b[2])
{
    return blas_perp_f32(a, b);
}

void small_methods_shapes(const double a[6], pair_usize_bool_t *BESSEMER_RESTRICT result)
{
    pair_usize_usize_t rows_columns;
    parts_shape_f64_2_3(a, &rows_columns);
    result->first = UINT64_C(10) * rows_columns.first + rows_columns.second;
    result->second = parts_is_square_f64_2_3(a);
}

void small_methods_squared(const double a[4], double result[BESSEMER_RESTRICT 4])
{
    const double copy[4] = {a[0], a[1], a[2], a[3]};
    {
        const double product[4] = {
            copy[0 + 2 * 0] * copy[0 + 2 * 0] + copy[0 + 2 * 1] * copy[1 + 2 * 0],
            copy[1 + 2 * 0] * copy[0 + 2 * 0] + copy[1 + 2 * 1] * copy[1 + 2 * 0],
            copy[0 + 2 * 0] * copy[0 + 2 * 1] + copy[0 + 2 * 1] * copy[1 + 2 * 1],
            copy[1 + 2 * 0] * copy[0 + 2 * 1] + copy[1 + 2 * 1] * copy[1 + 2 * 1]
        };
        result[0] = product[0];
        result[1] = product[1];
        result[2] = product[2];
        result[3] = product[3];
    }
}

void small_methods_rounded(const double a[6],
    pair_matrix2x3_f32_matrix2x3_f64_t *BESSEMER_RESTRICT result)
{
    elementwise_cast_f64_f32_2_3(a, result->first);
    double result_cast_f32_f64_2_3[6];
    elementwise_cast_f32_f64_2_3(result->first, result_cast_f32_f64_2_3);
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 6U; i++) {
        result->second[i] = result_cast_f32_f64_2_3[i] - a[i];
    }
}

void small_methods_centre(const double points[4][3],
    pair_vector3_f64_vector3_f64_t *BESSEMER_RESTRICT result)
{
    double sum[3] = {0.0, 0.0, 0.0};
    for (uint32_t i = 0U; i < 4U; i++) {
        sum[0] += points[i][0];
        sum[1] += points[i][1];
        sum[2] += points[i][2];
    }
    result->second[0] = 0.0;
    result->second[1] = 0.0;
    result->second[2] = 0.0;
    for (uint32_t i = 0U; i < 4U; i++) {
        result->second[0] += points[i][0] * 0.5;
        result->second[1] += points[i][1] * 0.5;
        result->second[2] += points[i][2] * 0.5;
    }
    result->first[0] = sum[0] / 4.0;
    result->first[1] = sum[1] / 4.0;
    result->first[2] = sum[2] / 4.0;
}

void small_methods_into_places(const double a[6], const double b[6],
    double product[BESSEMER_RESTRICT 4], double other[BESSEMER_RESTRICT 9])
{
    blas_mul_to_f64_2_3_2(a, b, product);
    blas_tr_mul_to_f64_2_3_3(a, a, other);
}

void small_methods_parts(const double state[6],
    triple_vector3_f64_vector3_f64_vector3_f64_t *BESSEMER_RESTRICT result)
{
    result->first[0] = state[0];
    result->first[1] = state[1];
    result->first[2] = state[2];
    result->second[0] = state[3];
    result->second[1] = state[4];
    result->second[2] = state[5];
    for (uint32_t column = 0U; column < 1U; column++) {
        for (uint32_t row = 0U; row < 3U; row++) {
            result->third[row] = result->first[row] + (double)row;
        }
    }
}
