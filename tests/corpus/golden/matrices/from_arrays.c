/* The C of tests/corpus/src/programs/matrices/from_arrays.rs. Written by a test. */

/* from_arrays.c */

void from_arrays_acceleration(const float raw[3], float scale, float result[BESSEMER_RESTRICT 3])
{
    result[0] = raw[0] * scale;
    result[1] = raw[1] * scale;
    result[2] = raw[2] * scale;
}

void from_arrays_corner(double x, double y, double result[2])
{
    result[0] = x + y;
    result[1] = x - y;
}

void from_arrays_window(const double samples[20], double result[BESSEMER_RESTRICT 20])
{
    for (uint32_t i = 0U; i < 20U; i++) {
        result[i] = samples[i];
    }
}

void from_arrays_columns(const double columns[3][2], double result[BESSEMER_RESTRICT 6])
{
    result[0 + 2 * 0] = columns[0][0];
    result[1 + 2 * 0] = columns[0][1];
    result[0 + 2 * 1] = columns[1][0];
    result[1 + 2 * 1] = columns[1][1];
    result[0 + 2 * 2] = columns[2][0];
    result[1 + 2 * 2] = columns[2][1];
}

void from_arrays_shear(float factor, pair_matrix2x2_f32_matrix1x2_f32_t *result)
{
    result->first[0 + 2 * 0] = 1.0F;
    result->first[1 + 2 * 0] = 0.0F;
    result->first[0 + 2 * 1] = factor;
    result->first[1 + 2 * 1] = 1.0F;
    result->second[0] = factor;
    result->second[1] = 2.0F;
}

void from_arrays_beside(const double first[2], double gain,
    pair_matrix2x2_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    double elements[2][2];
    elements[0][0] = first[0];
    elements[0][1] = first[1];
    elements[1][0] = gain;
    elements[1][1] = gain;
    const double elements_2[2][2] = {{gain, 1.0}, {first[0], first[1]}};
    result->first[0 + 2 * 0] = elements[0][0];
    result->first[1 + 2 * 0] = elements[0][1];
    result->first[0 + 2 * 1] = elements[1][0];
    result->first[1 + 2 * 1] = elements[1][1];
    result->second[0 + 2 * 0] = elements_2[0][0];
    result->second[1 + 2 * 0] = elements_2[0][1];
    result->second[0 + 2 * 1] = elements_2[1][0];
    result->second[1 + 2 * 1] = elements_2[1][1];
}

void from_arrays_packed(const double covariance[9], const float rates[3],
    pair_f64x3x3_f32x3_t *BESSEMER_RESTRICT result)
{
    result->first[0][0] = covariance[0 + 3 * 0];
    result->first[0][1] = covariance[1 + 3 * 0];
    result->first[0][2] = covariance[2 + 3 * 0];
    result->first[1][0] = covariance[0 + 3 * 1];
    result->first[1][1] = covariance[1 + 3 * 1];
    result->first[1][2] = covariance[2 + 3 * 1];
    result->first[2][0] = covariance[0 + 3 * 2];
    result->first[2][1] = covariance[1 + 3 * 2];
    result->first[2][2] = covariance[2 + 3 * 2];
    result->second[0] = rates[0];
    result->second[1] = rates[1];
    result->second[2] = rates[2];
}

void from_arrays_far(const float covariance[25], float columns[BESSEMER_RESTRICT 5][5])
{
    for (uint32_t i = 0U; i < 5U; i++) {
        for (uint32_t j = 0U; j < 5U; j++) {
            columns[i][j] = 0.0F;
        }
    }
    for (uint32_t col = 0U; col < 5U; col++) {
        for (uint32_t row = 0U; row < 5U; row++) {
            columns[col][row] = covariance[row + 5U * col];
        }
    }
}
