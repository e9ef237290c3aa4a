/* The C of tests/corpus/src/programs/matrices/filling.rs. Written by a test. */

/* filling.c */

void filling_tidy(double p[9], double least)
{
    matrix_edit_fill_lower_triangle_with_upper_triangle_f64_3(p);
    double elements[3];
    parts_diagonal_f64_3(p, elements);
    double diagonal[3];
    for (uint32_t i = 0U; i < 3U; i++) {
        if (elements[i] > least) {
            diagonal[i] = elements[i];
        } else {
            diagonal[i] = least;
        }
    }
    matrix_edit_set_diagonal_f64_3(p, diagonal);
}

bessemer_status_t filling_forget(double p[9], uint64_t state, double variance)
{
    if (state >= UINT64_C(3)) {
        return BESSEMER_STATUS_INDEX;
    }
    for (uint32_t column = 0U; column < 3U; column++) {
        p[(uint32_t)state + 3U * column] = 0.0;
    }
    for (uint32_t row = 0U; row < 3U; row++) {
        p[row + 3U * (uint32_t)state] = 0.0;
    }
    p[state + 3U * state] = variance;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t filling_exchanged(const float a[6], uint64_t one, uint64_t other,
    float result[BESSEMER_RESTRICT 6])
{
    float own_a[6];
    (void)memcpy(own_a, a, sizeof(float[6]));
    if (one >= UINT64_C(3) || other >= UINT64_C(3)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    for (uint32_t column = 0U; column < 2U; column++) {
        const float held = own_a[(uint32_t)one + 3U * column];
        own_a[(uint32_t)one + 3U * column] = own_a[(uint32_t)other + 3U * column];
        own_a[(uint32_t)other + 3U * column] = held;
    }
    (void)memcpy(result, own_a, sizeof(float[6]));
    return BESSEMER_STATUS_OK;
}

void filling_reset(double p[4], double variance)
{
    matrix_edit_fill_with_identity_f64_2_2(p);
    elementwise_scale_mut_f64_2_2(p, variance);
}
