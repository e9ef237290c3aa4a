/* The C of tests/corpus/src/programs/matrices/covariance_factors.rs. Written by a test. */

/* covariance_factors.c */

void covariance_factors_variances(const double p[9], option_vector3_f64_t *BESSEMER_RESTRICT result)
{
    option_udu_f64_3_t factors_option;
    udu_factored_f64_3(p, &factors_option);
    if (!factors_option.is_some) {
        *result = (option_vector3_f64_t){.is_some = false};
        return;
    }
    const udu_f64_3_t *const factors = &factors_option.value;
    result->is_some = true;
    result->value[0] = factors->d[0];
    result->value[1] = factors->d[1];
    result->value[2] = factors->d[2];
}

void covariance_factors_composed(const double p[4], double result[BESSEMER_RESTRICT 4])
{
    option_udu_f64_2_t factors;
    udu_factored_f64_2(p, &factors);
    if (factors.is_some) {
        double result_d_matrix[4];
        udu_f64_2_d_matrix(&factors.value, result_d_matrix);
        const double result_product[4] = {
            factors.value.u[0 + 2 * 0] * result_d_matrix[0 + 2 * 0]
                + factors.value.u[0 + 2 * 1] * result_d_matrix[1 + 2 * 0],
            factors.value.u[1 + 2 * 0] * result_d_matrix[0 + 2 * 0]
                + factors.value.u[1 + 2 * 1] * result_d_matrix[1 + 2 * 0],
            factors.value.u[0 + 2 * 0] * result_d_matrix[0 + 2 * 1]
                + factors.value.u[0 + 2 * 1] * result_d_matrix[1 + 2 * 1],
            factors.value.u[1 + 2 * 0] * result_d_matrix[0 + 2 * 1]
                + factors.value.u[1 + 2 * 1] * result_d_matrix[1 + 2 * 1]
        };
        {
            const double product[4] = {
                result_product[0 + 2 * 0] * factors.value.u[0 + 2 * 0]
                    + result_product[0 + 2 * 1] * factors.value.u[0 + 2 * 1],
                result_product[1 + 2 * 0] * factors.value.u[0 + 2 * 0]
                    + result_product[1 + 2 * 1] * factors.value.u[0 + 2 * 1],
                result_product[0 + 2 * 0] * factors.value.u[1 + 2 * 0]
                    + result_product[0 + 2 * 1] * factors.value.u[1 + 2 * 1],
                result_product[1 + 2 * 0] * factors.value.u[1 + 2 * 0]
                    + result_product[1 + 2 * 1] * factors.value.u[1 + 2 * 1]
            };
            result[0] = product[0];
            result[1] = product[1];
            result[2] = product[2];
            result[3] = product[3];
        }
    } else {
        result[0] = 0.0;
        result[1] = 0.0;
        result[2] = 0.0;
        result[3] = 0.0;
    }
}

void covariance_factors_gain(const double p[9], const double h[6], const double s[4],
    double result[BESSEMER_RESTRICT 6])
{
    option_ldl_f64_2_t factors;
    ldl_factored_f64_2(s, &factors);
    if (factors.is_some) {
        const double result_b[6] = {
            h[0 + 2 * 0] * p[0 + 3 * 0] + h[0 + 2 * 1] * p[1 + 3 * 0] + h[0 + 2 * 2] * p[2 + 3 * 0],
            h[1 + 2 * 0] * p[0 + 3 * 0] + h[1 + 2 * 1] * p[1 + 3 * 0] + h[1 + 2 * 2] * p[2 + 3 * 0],
            h[0 + 2 * 0] * p[0 + 3 * 1] + h[0 + 2 * 1] * p[1 + 3 * 1] + h[0 + 2 * 2] * p[2 + 3 * 1],
            h[1 + 2 * 0] * p[0 + 3 * 1] + h[1 + 2 * 1] * p[1 + 3 * 1] + h[1 + 2 * 2] * p[2 + 3 * 1],
            h[0 + 2 * 0] * p[0 + 3 * 2] + h[0 + 2 * 1] * p[1 + 3 * 2] + h[0 + 2 * 2] * p[2 + 3 * 2],
            h[1 + 2 * 0] * p[0 + 3 * 2] + h[1 + 2 * 1] * p[1 + 3 * 2] + h[1 + 2 * 2] * p[2 + 3 * 2]
        };
        double result_solve_3[6];
        ldl_f64_2_solve_3(&factors.value, result_b, result_solve_3);
        result[0 + 3 * 0] = result_solve_3[0 + 2 * 0];
        result[1 + 3 * 0] = result_solve_3[0 + 2 * 1];
        result[2 + 3 * 0] = result_solve_3[0 + 2 * 2];
        result[0 + 3 * 1] = result_solve_3[1 + 2 * 0];
        result[1 + 3 * 1] = result_solve_3[1 + 2 * 1];
        result[2 + 3 * 1] = result_solve_3[1 + 2 * 2];
    } else {
        for (uint32_t i = 0U; i < 6U; i++) {
            result[i] = 0.0;
        }
    }
}

void covariance_factors_full_rank(const float p[9], pair_bool_f32_t *BESSEMER_RESTRICT result)
{
    option_ldl_f32_3_t factors;
    ldl_factored_f32_3(p, &factors);
    const option_ldl_f32_3_t *const option = &factors;
    const bool first = option->is_some && ldl_f32_3_is_positive(&option->value);
    float second;
    if (factors.is_some) {
        const ldl_f32_3_t *const it = &factors.value;
        second = ldl_f32_3_determinant(it);
    } else {
        second = 0.0F;
    }
    result->first = first;
    result->second = second;
}
