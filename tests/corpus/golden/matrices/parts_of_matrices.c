/* The C of tests/corpus/src/programs/matrices/parts_of_matrices.rs. Written by a test. */

/* parts_of_matrices.c */

void parts_of_matrices_off(const double turn[9], double result[BESSEMER_RESTRICT 2])
{
    result[0] = parts_trace_f64_3(turn) - 3.0;
    double largest = fabs(turn[0 + 3 * 0]);
    BESSEMER_FEW_PASSES
    for (uint32_t i = 1U; i < 9U; i++) {
        largest = larger_magnitude_f64(largest, fabs(turn[i]));
    }
    result[1] = largest;
}

void parts_of_matrices_learn(double information[BESSEMER_RESTRICT 9], const double x[3],
    double forgetting)
{
    blas_ger_f64_3_3(information, 1.0, x, x, forgetting);
}

void parts_of_matrices_weights(const float raw[4], float result[BESSEMER_RESTRICT 4])
{
    const float result_sum_f32_4_1 = matrix_statistics_sum_f32_4_1(raw);
    result[0] = raw[0] / result_sum_f32_4_1;
    result[1] = raw[1] / result_sum_f32_4_1;
    result[2] = raw[2] / result_sum_f32_4_1;
    result[3] = raw[3] / result_sum_f32_4_1;
}
