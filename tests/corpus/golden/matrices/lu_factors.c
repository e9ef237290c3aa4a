/* The C of tests/corpus/src/programs/matrices/lu_factors.rs. Written by a test. */

/* lu_factors.c */

void lu_factors_refined(const double a[9], const double b[3],
    option_vector3_f64_t *BESSEMER_RESTRICT result)
{
    lu_f64_3_t lu;
    lu_factored_f64_3(a, &lu);
    option_vector3_f64_t x_option;
    lu_f64_3_solve_1(&lu, b, &x_option);
    if (!x_option.is_some) {
        *result = (option_vector3_f64_t){.is_some = false};
        return;
    }
    const double x[3] = {x_option.value[0], x_option.value[1], x_option.value[2]};
    const double residual_product[3] = {
        a[0 + 3 * 0] * x[0] + a[0 + 3 * 1] * x[1] + a[0 + 3 * 2] * x[2],
        a[1 + 3 * 0] * x[0] + a[1 + 3 * 1] * x[1] + a[1 + 3 * 2] * x[2],
        a[2 + 3 * 0] * x[0] + a[2 + 3 * 1] * x[1] + a[2 + 3 * 2] * x[2]
    };
    const double residual[3] = {
        b[0] - residual_product[0],
        b[1] - residual_product[1],
        b[2] - residual_product[2]
    };
    option_vector3_f64_t correction_option;
    lu_f64_3_solve_1(&lu, residual, &correction_option);
    if (!correction_option.is_some) {
        *result = (option_vector3_f64_t){.is_some = false};
        return;
    }
    const double correction[3] = {
        correction_option.value[0],
        correction_option.value[1],
        correction_option.value[2]
    };
    result->value[0] = x[0] + correction[0];
    result->value[1] = x[1] + correction[1];
    result->value[2] = x[2] + correction[2];
    result->is_some = true;
}

void lu_factors_both(const float a[16], pair_f32_matrix4x4_f32_t *BESSEMER_RESTRICT result)
{
    lu_f32_4_t lu;
    lu_factored_f32_4(a, &lu);
    const float first = lu_f32_4_determinant(&lu);
    option_matrix4x4_f32_t option;
    lu_f32_4_try_inverse(&lu, &option);
    for (uint32_t i = 0U; i < 16U; i++) {
        result->second[i] = 0.0F;
    }
    if (option.is_some) {
        (void)memcpy(result->second, option.value, sizeof(float[16]));
    }
    result->first = first;
}
