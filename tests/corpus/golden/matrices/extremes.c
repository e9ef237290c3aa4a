/* The C of tests/corpus/src/programs/matrices/extremes.rs. Written by a test. */

/* extremes.c */

double extremes_range(const double a[6])
{
    return matrix_extremes_max_f64_2_3(a) - matrix_extremes_min_f64_2_3(a);
}

void extremes_strongest(const float speeds[5], pair_usize_f32_t *BESSEMER_RESTRICT result)
{
    matrix_extremes_argmax_f32_5(speeds, result);
}

uint64_t extremes_worst(const double error[3])
{
    return matrix_extremes_iamax_f64_3(error);
}

void extremes_within(const double command[3], const double low[3], const double high[3],
    double result[BESSEMER_RESTRICT 3])
{
    double result_a[3];
    matrix_extremes_sup_f64_3_1(command, low, result_a);
    matrix_extremes_inf_f64_3_1(result_a, high, result);
}

void extremes_magnitudes(const float a[4], float result[BESSEMER_RESTRICT 4])
{
    elementwise_abs_f32_2_2(a, result);
}
