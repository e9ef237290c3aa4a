/* The C of tests/corpus/src/programs/matrices/least_squares.rs. Written by a test. */

/* programs_matrices_least_squares.c */

void programs_matrices_least_squares_line(const double x[6], const double y[6],
    option_vector2_f64_t *BESSEMER_RESTRICT result)
{
    double rows[12] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    for (uint32_t k = 0U; k < 6U; k++) {
        rows[k + 6U * 1U] = x[k];
    }
    qr_f64_6_2_t qr;
    qr_factored_f64_6_2(rows, &qr);
    double right_q[12];
    qr_f64_6_2_q(&qr, right_q);
    const double right[2] = {
        0.0 + right_q[0 + 6 * 0] * y[0] + right_q[1 + 6 * 0] * y[1] + right_q[2 + 6 * 0] * y[2]
            + right_q[3 + 6 * 0] * y[3] + right_q[4 + 6 * 0] * y[4] + right_q[5 + 6 * 0] * y[5],
        0.0 + right_q[0 + 6 * 1] * y[0] + right_q[1 + 6 * 1] * y[1] + right_q[2 + 6 * 1] * y[2]
            + right_q[3 + 6 * 1] * y[3] + right_q[4 + 6 * 1] * y[4] + right_q[5 + 6 * 1] * y[5]
    };
    double result_a[4];
    qr_f64_6_2_r(&qr, result_a);
    triangular_solve_upper_triangular_f64_2_1(result_a, right, result);
}

void programs_matrices_least_squares_solved(const float a[9], const float b[3],
    option_vector3_f32_t *BESSEMER_RESTRICT result)
{
    qr_f32_3_3_t result_qr;
    qr_factored_f32_3_3(a, &result_qr);
    qr_solve_f32_3_1(&result_qr, b, result);
}
