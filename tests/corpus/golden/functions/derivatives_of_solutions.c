/* The C of tests/corpus/src/programs/functions/derivatives_of_solutions.rs. Written by a test. */

/* derivatives_of_solutions.c */

void derivatives_of_solutions_deflected(const double springs[2], const double load[2],
    double result[BESSEMER_RESTRICT 2])
{
    const double stiffness[4] = {
        springs[0] + springs[1], -springs[1],
        -springs[1], springs[1]
    };
    option_vector2_f64_t deflection;
    lu_solve_f64_2(stiffness, load, &deflection);
    if (deflection.is_some) {
        result[0] = deflection.value[0];
        result[1] = deflection.value[1];
    } else {
        result[0] = 0.0;
        result[1] = 0.0;
    }
}

void derivatives_of_solutions_deflected_jacobian(const double springs[2], const double load[2],
    triple_vector2_f64_matrix2x2_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    const double stiffness_0 = springs[0] + springs[1];
    const double stiffness_1 = -springs[1];
    const double stiffness_2 = -springs[1];
    const double matrix[4] = {
        stiffness_0, stiffness_1,
        stiffness_2, springs[1]
    };
    double solution[2] = {load[0], load[1]};
    const bool solved = solve_f64_2(matrix, solution);
    double solution_d[8] = {
        -solution[0], 0.0,
        -solution[0] - (-solution[1]), solution[0] - solution[1],
        1.0, 0.0,
        0.0, 1.0
    };
    (void)solve_f64_2x4(matrix, solution_d);
    double result_0;
    double result_0_d0;
    double result_0_d1;
    double result_0_d2;
    double result_0_d3;
    double result_1;
    double result_1_d0;
    double result_1_d1;
    double result_1_d2;
    double result_1_d3;
    if (solved) {
        result_0 = solution[0];
        result_0_d0 = solution_d[0 + 2 * 0];
        result_0_d1 = solution_d[0 + 2 * 1];
        result_0_d2 = solution_d[0 + 2 * 2];
        result_0_d3 = solution_d[0 + 2 * 3];
        result_1 = solution[1];
        result_1_d0 = solution_d[1 + 2 * 0];
        result_1_d1 = solution_d[1 + 2 * 1];
        result_1_d2 = solution_d[1 + 2 * 2];
        result_1_d3 = solution_d[1 + 2 * 3];
    } else {
        result_0 = 0.0;
        result_0_d0 = 0.0;
        result_0_d1 = 0.0;
        result_0_d2 = 0.0;
        result_0_d3 = 0.0;
        result_1 = 0.0;
        result_1_d0 = 0.0;
        result_1_d1 = 0.0;
        result_1_d2 = 0.0;
        result_1_d3 = 0.0;
    }
    result->second[0] = 0.0;
    result->second[1] = 0.0;
    result->second[2] = 0.0;
    result->second[3] = 0.0;
    result->second[0 + 2 * 0] = result_0_d0;
    result->second[0 + 2 * 1] = result_0_d1;
    result->second[1 + 2 * 0] = result_1_d0;
    result->second[1 + 2 * 1] = result_1_d1;
    result->third[0] = 0.0;
    result->third[1] = 0.0;
    result->third[2] = 0.0;
    result->third[3] = 0.0;
    result->third[0 + 2 * 0] = result_0_d2;
    result->third[0 + 2 * 1] = result_0_d3;
    result->third[1 + 2 * 0] = result_1_d2;
    result->third[1 + 2 * 1] = result_1_d3;
    result->first[0] = result_0;
    result->first[1] = result_1;
}

double derivatives_of_solutions_surprise(const double s[4], const double difference[2])
{
    option_cholesky_factor_f64_2_t factor;
    cholesky_factored_f64_2(s, &factor);
    if (factor.is_some) {
        double result_solve_1[2];
        cholesky_factor_f64_2_solve_1(&factor.value, difference, result_solve_1);
        return difference[0] * result_solve_1[0] + difference[1] * result_solve_1[1];
    } else {
        return -1.0;
    }
}

void derivatives_of_solutions_surprise_gradient(const double s[4], const double difference[2],
    triple_f64_matrix1x4_f64_matrix1x2_f64_t *BESSEMER_RESTRICT result)
{
    double lower[4];
    cholesky_lower_f64_2(s, lower);
    const bool factor_0 = lower[0 + 2 * 0] > 0.0;
    double result_value;
    double result_d0;
    double result_d1;
    double result_d3;
    double result_d4;
    double result_d5;
    if (factor_0) {
        double solution[2] = {difference[0], difference[1]};
        cholesky_solve_f64_2(lower, solution);
        double solution_d[10] = {
            -solution[0], 0.0,
            -solution[1], -solution[0],
            0.0, -solution[1],
            1.0, 0.0,
            0.0, 1.0
        };
        cholesky_solve_f64_2x5(lower, solution_d);
        const double result_2 = difference[0] * solution[0] + difference[1] * solution[1];
        const double result_d0_2 = difference[0] * solution_d[0 + 2 * 0]
            + difference[1] * solution_d[1 + 2 * 0];
        const double result_d1_2 = difference[0] * solution_d[0 + 2 * 1]
            + difference[1] * solution_d[1 + 2 * 1];
        const double result_d3_2 = difference[0] * solution_d[0 + 2 * 2]
            + difference[1] * solution_d[1 + 2 * 2];
        const double result_d4_2 = solution[0] + difference[0] * solution_d[0 + 2 * 3]
            + difference[1] * solution_d[1 + 2 * 3];
        const double result_d5_2 = difference[0] * solution_d[0 + 2 * 4]
            + (solution[1] + difference[1] * solution_d[1 + 2 * 4]);
        result_value = result_2;
        result_d0 = result_d0_2;
        result_d1 = result_d1_2;
        result_d3 = result_d3_2;
        result_d4 = result_d4_2;
        result_d5 = result_d5_2;
    } else {
        const double result_2 = -1.0;
        result_value = result_2;
        result_d0 = 0.0;
        result_d1 = 0.0;
        result_d3 = 0.0;
        result_d4 = 0.0;
        result_d5 = 0.0;
    }
    result->second[0] = 0.0;
    result->second[1] = 0.0;
    result->second[2] = 0.0;
    result->second[3] = 0.0;
    result->second[0] = result_d0;
    result->second[1] = result_d1;
    result->second[3] = result_d3;
    result->third[0] = 0.0;
    result->third[1] = 0.0;
    result->third[0] = result_d4;
    result->third[1] = result_d5;
    result->first = result_value;
}

void derivatives_of_solutions_inverted(const double a[4], double scale,
    double result[BESSEMER_RESTRICT 4])
{
    const double scaled[4] = {
        a[0 + 2 * 0] * scale,
        a[1 + 2 * 0] * scale,
        a[0 + 2 * 1] * scale,
        a[1 + 2 * 1] * scale
    };
    option_matrix2x2_f64_t option;
    systems_inverse_f64_2(scaled, &option);
    result[0] = scaled[0];
    result[1] = scaled[1];
    result[2] = scaled[2];
    result[3] = scaled[3];
    if (option.is_some) {
        result[0] = option.value[0];
        result[1] = option.value[1];
        result[2] = option.value[2];
        result[3] = option.value[3];
    }
}

void derivatives_of_solutions_inverted_slope(const double a[4], double scale,
    pair_matrix2x2_f64_vector4_f64_t *BESSEMER_RESTRICT result)
{
    const double scaled_0 = a[0 + 2 * 0] * scale;
    const double scaled_1 = a[1 + 2 * 0] * scale;
    const double scaled_2 = a[0 + 2 * 1] * scale;
    const double scaled_3 = a[1 + 2 * 1] * scale;
    double inverse[4] = {
        scaled_0, scaled_1,
        scaled_2, scaled_3
    };
    const bool inverted = inverse_f64_2(inverse);
    double inverse_d[4] = {
        a[0 + 2 * 0], a[1 + 2 * 0],
        a[0 + 2 * 1], a[1 + 2 * 1]
    };
    if (inverted) {
        const double inverse_d_matrix[4] = {
            -(inverse[0 + 2 * 0] * a[0 + 2 * 0]) - inverse[1 + 2 * 0] * a[0 + 2 * 1],
                -(inverse[0 + 2 * 0] * a[1 + 2 * 0]) - inverse[1 + 2 * 0] * a[1 + 2 * 1],
            -(inverse[0 + 2 * 1] * a[0 + 2 * 0]) - inverse[1 + 2 * 1] * a[0 + 2 * 1],
                -(inverse[0 + 2 * 1] * a[1 + 2 * 0]) - inverse[1 + 2 * 1] * a[1 + 2 * 1]
        };
        {
            const double product[4] = {
                inverse[0 + 2 * 0] * inverse_d_matrix[0 + 2 * 0]
                    + inverse[0 + 2 * 1] * inverse_d_matrix[1 + 2 * 0],
                inverse[1 + 2 * 0] * inverse_d_matrix[0 + 2 * 0]
                    + inverse[1 + 2 * 1] * inverse_d_matrix[1 + 2 * 0],
                inverse[0 + 2 * 0] * inverse_d_matrix[0 + 2 * 1]
                    + inverse[0 + 2 * 1] * inverse_d_matrix[1 + 2 * 1],
                inverse[1 + 2 * 0] * inverse_d_matrix[0 + 2 * 1]
                    + inverse[1 + 2 * 1] * inverse_d_matrix[1 + 2 * 1]
            };
            inverse_d[0] = product[0];
            inverse_d[1] = product[1];
            inverse_d[2] = product[2];
            inverse_d[3] = product[3];
        }
    }
    double result_0;
    double result_0_d0;
    double result_1;
    double result_1_d0;
    double result_2;
    double result_2_d0;
    double result_3;
    double result_3_d0;
    if (inverted) {
        result_0 = inverse[0 + 2 * 0];
        result_0_d0 = inverse_d[0 + 2 * 0];
        result_1 = inverse[1 + 2 * 0];
        result_1_d0 = inverse_d[1 + 2 * 0];
        result_2 = inverse[0 + 2 * 1];
        result_2_d0 = inverse_d[0 + 2 * 1];
        result_3 = inverse[1 + 2 * 1];
        result_3_d0 = inverse_d[1 + 2 * 1];
    } else {
        result_0 = scaled_0;
        result_0_d0 = a[0 + 2 * 0];
        result_1 = scaled_1;
        result_1_d0 = a[1 + 2 * 0];
        result_2 = scaled_2;
        result_2_d0 = a[0 + 2 * 1];
        result_3 = scaled_3;
        result_3_d0 = a[1 + 2 * 1];
    }
    result->second[0] = result_0_d0;
    result->second[1] = result_1_d0;
    result->second[2] = result_2_d0;
    result->second[3] = result_3_d0;
    result->first[0 + 2 * 0] = result_0;
    result->first[1 + 2 * 0] = result_1;
    result->first[0 + 2 * 1] = result_2;
    result->first[1 + 2 * 1] = result_3;
}

void derivatives_of_solutions_determinants(const double a[16], double shift,
    double result[BESSEMER_RESTRICT 2])
{
    double shifted[16];
    (void)memcpy(shifted, a, sizeof(double[16]));
    double part[9];
    for (uint32_t k = 0U; k < 4U; k++) {
        shifted[k + 4U * k] += shift;
    }
    for (uint32_t column = 0U; column < 3U; column++) {
        for (uint32_t row = 0U; row < 3U; row++) {
            part[row + 3U * column] = shifted[row + 4U * column];
        }
    }
    result[0] = determinant_f64_4(shifted);
    result[1] = determinant_f64_3(part);
}

void derivatives_of_solutions_determinant_slopes(const double a[16], double shift,
    pair_vector2_f64_vector2_f64_t *BESSEMER_RESTRICT result)
{
    const double shifted_0 = a[0 + 4 * 0] + shift;
    const double shifted_5 = a[1 + 4 * 1] + shift;
    const double shifted_10 = a[2 + 4 * 2] + shift;
    const double shifted_15 = a[3 + 4 * 3] + shift;
    const double matrix[16] = {
        shifted_0, a[1 + 4 * 0], a[2 + 4 * 0], a[3 + 4 * 0],
        a[0 + 4 * 1], shifted_5, a[2 + 4 * 1], a[3 + 4 * 1],
        a[0 + 4 * 2], a[1 + 4 * 2], shifted_10, a[3 + 4 * 2],
        a[0 + 4 * 3], a[1 + 4 * 3], a[2 + 4 * 3], shifted_15
    };
    const double determinant = determinant_f64_4(matrix);
    double inverse[16];
    (void)memcpy(inverse, BESSEMER_IDENTITY_4, sizeof(double[16]));
    (void)solve_f64_4x4(matrix, inverse);
    const double minor = shifted_5 * shifted_10 - a[2 + 4 * 1] * a[1 + 4 * 2];
    const double minor_d0 = shifted_10 + shifted_5;
    const double minor_2 = a[1 + 4 * 0] * shifted_10 - a[2 + 4 * 0] * a[1 + 4 * 2];
    const double minor_3 = a[1 + 4 * 0] * a[2 + 4 * 1] - a[2 + 4 * 0] * shifted_5;
    const double minor_d0_2 = -a[2 + 4 * 0];
    const double result_0_d0 = determinant
        * (inverse[0 + 4 * 0] + inverse[1 + 4 * 1] + inverse[2 + 4 * 2] + inverse[3 + 4 * 3]);
    const double result_1 = shifted_0 * minor - a[0 + 4 * 1] * minor_2 + a[0 + 4 * 2] * minor_3;
    const double result_1_d0 = minor + shifted_0 * minor_d0 - a[0 + 4 * 1] * a[1 + 4 * 0]
        + a[0 + 4 * 2] * minor_d0_2;
    result->second[0] = result_0_d0;
    result->second[1] = result_1_d0;
    result->first[0] = determinant;
    result->first[1] = result_1;
}

void derivatives_of_solutions_refined(const double a[4], const double b[2],
    double result[BESSEMER_RESTRICT 2])
{
    lu_f64_2_t lu;
    lu_factored_f64_2(a, &lu);
    option_vector2_f64_t x_option;
    lu_f64_2_solve_1(&lu, b, &x_option);
    double x[2] = {0.0, 0.0};
    if (x_option.is_some) {
        x[0] = x_option.value[0];
        x[1] = x_option.value[1];
    }
    const double residual_product[2] = {
        a[0 + 2 * 0] * x[0] + a[0 + 2 * 1] * x[1],
        a[1 + 2 * 0] * x[0] + a[1 + 2 * 1] * x[1]
    };
    const double residual[2] = {b[0] - residual_product[0], b[1] - residual_product[1]};
    option_vector2_f64_t option;
    lu_f64_2_solve_1(&lu, residual, &option);
    double result_choice[2] = {0.0, 0.0};
    if (option.is_some) {
        result_choice[0] = option.value[0];
        result_choice[1] = option.value[1];
    }
    result[0] = x[0] + result_choice[0];
    result[1] = x[1] + result_choice[1];
}

void derivatives_of_solutions_refined_jacobian(const double a[4], const double b[2],
    pair_vector2_f64_matrix2x4_f64_t *BESSEMER_RESTRICT result)
{
    double solution[2] = {b[0], b[1]};
    const bool solved = solve_f64_2(a, solution);
    double solution_d[8] = {
        -solution[0], 0.0,
        0.0, -solution[0],
        -solution[1], 0.0,
        0.0, -solution[1]
    };
    (void)solve_f64_2x4(a, solution_d);
    double x_0;
    double x_0_d0;
    double x_0_d1;
    double x_0_d2;
    double x_0_d3;
    double x_1;
    double x_1_d0;
    double x_1_d1;
    double x_1_d2;
    double x_1_d3;
    if (solved) {
        x_0 = solution[0];
        x_0_d0 = solution_d[0 + 2 * 0];
        x_0_d1 = solution_d[0 + 2 * 1];
        x_0_d2 = solution_d[0 + 2 * 2];
        x_0_d3 = solution_d[0 + 2 * 3];
        x_1 = solution[1];
        x_1_d0 = solution_d[1 + 2 * 0];
        x_1_d1 = solution_d[1 + 2 * 1];
        x_1_d2 = solution_d[1 + 2 * 2];
        x_1_d3 = solution_d[1 + 2 * 3];
    } else {
        x_0 = 0.0;
        x_0_d0 = 0.0;
        x_0_d1 = 0.0;
        x_0_d2 = 0.0;
        x_0_d3 = 0.0;
        x_1 = 0.0;
        x_1_d0 = 0.0;
        x_1_d1 = 0.0;
        x_1_d2 = 0.0;
        x_1_d3 = 0.0;
    }
    const double residual_0 = a[0 + 2 * 1] * x_1 + a[0 + 2 * 0] * x_0;
    const double residual_0_d0 = a[0 + 2 * 1] * x_1_d0 + (x_0 + a[0 + 2 * 0] * x_0_d0);
    const double residual_0_d1 = a[0 + 2 * 1] * x_1_d1 + a[0 + 2 * 0] * x_0_d1;
    const double residual_0_d2 = x_1 + a[0 + 2 * 1] * x_1_d2 + a[0 + 2 * 0] * x_0_d2;
    const double residual_0_d3 = a[0 + 2 * 1] * x_1_d3 + a[0 + 2 * 0] * x_0_d3;
    const double residual_1 = a[1 + 2 * 1] * x_1 + a[1 + 2 * 0] * x_0;
    const double residual_1_d0 = a[1 + 2 * 1] * x_1_d0 + a[1 + 2 * 0] * x_0_d0;
    const double residual_1_d1 = a[1 + 2 * 1] * x_1_d1 + (x_0 + a[1 + 2 * 0] * x_0_d1);
    const double residual_1_d2 = a[1 + 2 * 1] * x_1_d2 + a[1 + 2 * 0] * x_0_d2;
    const double residual_1_d3 = x_1 + a[1 + 2 * 1] * x_1_d3 + a[1 + 2 * 0] * x_0_d3;
    const double residual_0_2 = b[0] - residual_0;
    const double residual_0_d0_2 = -residual_0_d0;
    const double residual_0_d1_2 = -residual_0_d1;
    const double residual_0_d2_2 = -residual_0_d2;
    const double residual_0_d3_2 = -residual_0_d3;
    const double residual_1_2 = b[1] - residual_1;
    const double residual_1_d0_2 = -residual_1_d0;
    const double residual_1_d1_2 = -residual_1_d1;
    const double residual_1_d2_2 = -residual_1_d2;
    const double residual_1_d3_2 = -residual_1_d3;
    double solution_2[2] = {residual_0_2, residual_1_2};
    const bool solved_2 = solve_f64_2(a, solution_2);
    double solution_d_2[8] = {
        residual_0_d0_2 - solution_2[0], residual_1_d0_2,
        residual_0_d1_2, residual_1_d1_2 - solution_2[0],
        residual_0_d2_2 - solution_2[1], residual_1_d2_2,
        residual_0_d3_2, residual_1_d3_2 - solution_2[1]
    };
    (void)solve_f64_2x4(a, solution_d_2);
    double result_choice_0;
    double result_choice_0_d0;
    double result_choice_0_d1;
    double result_choice_0_d2;
    double result_choice_0_d3;
    double result_choice_1;
    double result_choice_1_d0;
    double result_choice_1_d1;
    double result_choice_1_d2;
    double result_choice_1_d3;
    if (solved_2) {
        result_choice_0 = solution_2[0];
        result_choice_0_d0 = solution_d_2[0 + 2 * 0];
        result_choice_0_d1 = solution_d_2[0 + 2 * 1];
        result_choice_0_d2 = solution_d_2[0 + 2 * 2];
        result_choice_0_d3 = solution_d_2[0 + 2 * 3];
        result_choice_1 = solution_2[1];
        result_choice_1_d0 = solution_d_2[1 + 2 * 0];
        result_choice_1_d1 = solution_d_2[1 + 2 * 1];
        result_choice_1_d2 = solution_d_2[1 + 2 * 2];
        result_choice_1_d3 = solution_d_2[1 + 2 * 3];
    } else {
        result_choice_0 = 0.0;
        result_choice_0_d0 = 0.0;
        result_choice_0_d1 = 0.0;
        result_choice_0_d2 = 0.0;
        result_choice_0_d3 = 0.0;
        result_choice_1 = 0.0;
        result_choice_1_d0 = 0.0;
        result_choice_1_d1 = 0.0;
        result_choice_1_d2 = 0.0;
        result_choice_1_d3 = 0.0;
    }
    const double result_0 = x_0 + result_choice_0;
    const double result_0_d0 = x_0_d0 + result_choice_0_d0;
    const double result_0_d1 = x_0_d1 + result_choice_0_d1;
    const double result_0_d2 = x_0_d2 + result_choice_0_d2;
    const double result_0_d3 = x_0_d3 + result_choice_0_d3;
    const double result_1 = x_1 + result_choice_1;
    const double result_1_d0 = x_1_d0 + result_choice_1_d0;
    const double result_1_d1 = x_1_d1 + result_choice_1_d1;
    const double result_1_d2 = x_1_d2 + result_choice_1_d2;
    const double result_1_d3 = x_1_d3 + result_choice_1_d3;
    for (uint32_t i = 0U; i < 8U; i++) {
        result->second[i] = 0.0;
    }
    result->second[0 + 2 * 0] = result_0_d0;
    result->second[0 + 2 * 1] = result_0_d1;
    result->second[0 + 2 * 2] = result_0_d2;
    result->second[0 + 2 * 3] = result_0_d3;
    result->second[1 + 2 * 0] = result_1_d0;
    result->second[1 + 2 * 1] = result_1_d1;
    result->second[1 + 2 * 2] = result_1_d2;
    result->second[1 + 2 * 3] = result_1_d3;
    result->first[0] = result_0;
    result->first[1] = result_1;
}

void derivatives_of_solutions_solved_in_place(double stiffness, const float load[2],
    float result[BESSEMER_RESTRICT 2])
{
    const float stiffness_2 = (float)stiffness;
    float a[4] = {
        1.0F + stiffness_2, -stiffness_2,
        -stiffness_2, stiffness_2 * 2.0F
    };
    float x[2] = {load[0], load[1]};
    if (lu_solve_f32_2(a, x)) {
        result[0] = x[0];
        result[1] = x[1];
    } else {
        result[0] = load[0];
        result[1] = load[1];
    }
}

void derivatives_of_solutions_solved_in_place_jacobian(double stiffness, const float load[2],
    pair_vector2_f32_matrix2x2_f32_t *BESSEMER_RESTRICT result)
{
    const float stiffness_2 = (float)stiffness;
    const float a_0 = 1.0F + stiffness_2;
    const float a_1 = -stiffness_2;
    const float a_2 = -stiffness_2;
    const float a_3 = stiffness_2 * 2.0F;
    const float matrix[4] = {
        a_0, a_1,
        a_2, a_3
    };
    float factors[4] = {matrix[0], matrix[1], matrix[2], matrix[3]};
    float solution[2] = {load[0], load[1]};
    const bool solved = lu_solve_f32_2(factors, solution);
    float solution_d[4] = {
        1.0F, 0.0F,
        0.0F, 1.0F
    };
    (void)solve_f32_2x2(matrix, solution_d);
    float result_0;
    float result_0_d0;
    float result_0_d1;
    float result_1;
    float result_1_d0;
    float result_1_d1;
    if (solved) {
        result_0 = solution[0];
        result_0_d0 = solution_d[0 + 2 * 0];
        result_0_d1 = solution_d[0 + 2 * 1];
        result_1 = solution[1];
        result_1_d0 = solution_d[1 + 2 * 0];
        result_1_d1 = solution_d[1 + 2 * 1];
    } else {
        result_0 = load[0];
        result_0_d0 = 1.0F;
        result_0_d1 = 0.0F;
        result_1 = load[1];
        result_1_d0 = 0.0F;
        result_1_d1 = 1.0F;
    }
    result->second[0] = 0.0F;
    result->second[1] = 0.0F;
    result->second[2] = 0.0F;
    result->second[3] = 0.0F;
    result->second[0 + 2 * 0] = result_0_d0;
    result->second[0 + 2 * 1] = result_0_d1;
    result->second[1 + 2 * 0] = result_1_d0;
    result->second[1 + 2 * 1] = result_1_d1;
    result->first[0] = result_0;
    result->first[1] = result_1;
}
