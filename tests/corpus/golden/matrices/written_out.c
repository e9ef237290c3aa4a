/* The C of tests/corpus/src/programs/matrices/written_out.rs. Written by a test. */

/* written_out.c */

void written_out_taps(double edge, double result[7])
{
    result[0] = edge;
    result[1] = -0.1;
    result[2] = 0.25;
    result[3] = 0.5;
    result[4] = 0.25;
    result[5] = -0.1;
    result[6] = fabs(edge);
}

void written_out_transition(double time, double result[9])
{
    result[0 + 3 * 0] = 1.0;
    result[1 + 3 * 0] = 0.0;
    result[2 + 3 * 0] = 0.0;
    result[0 + 3 * 1] = time;
    result[1 + 3 * 1] = 1.0;
    result[2 + 3 * 1] = 0.0;
    result[0 + 3 * 2] = 0.0;
    result[1 + 3 * 2] = -time;
    result[2 + 3 * 2] = 1.0;
}

void written_out_frame(const float x[3], const float y[3], float result[BESSEMER_RESTRICT 9])
{
    const float result_cross[3] = {
        x[1] * y[2] - x[2] * y[1],
        x[2] * y[0] - x[0] * y[2],
        x[0] * y[1] - x[1] * y[0]
    };
    const float result_columns[3][3] = {
        {x[0], x[1], x[2]},
        {y[0], y[1], y[2]},
        {result_cross[0], result_cross[1], result_cross[2]}
    };
    parts_from_columns_f32_3_3((const float (*)[3])result_columns, result);
}

void written_out_table(const double values[6], double result[BESSEMER_RESTRICT 6])
{
    parts_from_row_slice_f64_2_3_6(values, result);
}

void written_out_across(const double v[3], double result[BESSEMER_RESTRICT 3])
{
    const double result_vector[3] = {0.0, 0.0, 1.0};
    result[0] = v[1] * result_vector[2] - v[2] * result_vector[1];
    result[1] = v[2] * result_vector[0] - v[0] * result_vector[2];
    result[2] = v[0] * result_vector[1] - v[1] * result_vector[0];
}

void written_out_others(const double v[3], double noise, double result[BESSEMER_RESTRICT 9])
{
    double result_cross_matrix_f64[9];
    parts_cross_matrix_f64(v, result_cross_matrix_f64);
    double result_from_diagonal_element_f64_3_3[9];
    parts_from_diagonal_element_f64_3_3(noise, result_from_diagonal_element_f64_3_3);
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 9U; i++) {
        result[i] = result_cross_matrix_f64[i] + result_from_diagonal_element_f64_3_3[i];
    }
}

double written_out_mean(const double a[6])
{
    return matrix_statistics_sum_f64_2_3(a) / 6.0;
}
