/* The C of tests/corpus/src/programs/matrices/statistics.rs. Written by a test. */

/* statistics.c */

void statistics_bias(const double samples[24],
    pair_vector3_f64_vector3_f64_t *BESSEMER_RESTRICT result)
{
    matrix_statistics_column_mean_f64_3_8(samples, result->first);
    matrix_statistics_column_variance_f64_3_8(samples, result->second);
}

void statistics_means(const float a[8], float result[BESSEMER_RESTRICT 2])
{
    matrix_statistics_row_mean_f32_4_2(a, result);
}

double statistics_spread(const double window[6])
{
    return matrix_statistics_variance_f64_6_1(window);
}

void statistics_shares(const double a[9], double result[BESSEMER_RESTRICT 3])
{
    double result_column_sum_f64_3_3[3];
    matrix_statistics_column_sum_f64_3_3(a, result_column_sum_f64_3_3);
    const double result_sum_f64_3_3 = matrix_statistics_sum_f64_3_3(a);
    result[0] = result_column_sum_f64_3_3[0] / result_sum_f64_3_3;
    result[1] = result_column_sum_f64_3_3[1] / result_sum_f64_3_3;
    result[2] = result_column_sum_f64_3_3[2] / result_sum_f64_3_3;
}
