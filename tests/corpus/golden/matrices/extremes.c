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
    result[0] = lower_f64(upper_f64(command[0], low[0]), high[0]);
    result[1] = lower_f64(upper_f64(command[1], low[1]), high[1]);
    result[2] = lower_f64(upper_f64(command[2], low[2]), high[2]);
}

void extremes_magnitudes(const float a[4], float result[BESSEMER_RESTRICT 4])
{
    result[0 + 2 * 0] = fabsf(a[0 + 2 * 0]);
    result[1 + 2 * 0] = fabsf(a[1 + 2 * 0]);
    result[0 + 2 * 1] = fabsf(a[0 + 2 * 1]);
    result[1 + 2 * 1] = fabsf(a[1 + 2 * 1]);
}
