/* The C of tests/corpus/src/programs/matrices/closures_over_matrices.rs. Written by a test. */

/* closures_over_matrices.c */

void closures_over_matrices_limited(const double a[9], double limit,
    double result[BESSEMER_RESTRICT 9])
{
    for (uint32_t i = 0U; i < 9U; i++) {
        if (a[i] > limit) {
            result[i] = limit;
        } else {
            result[i] = a[i];
        }
    }
}

void closures_over_matrices_blended(const float a[9], const float b[9], float share,
    float result[BESSEMER_RESTRICT 9])
{
    for (uint32_t i = 0U; i < 9U; i++) {
        result[i] = a[i] + (b[i] - a[i]) * share;
    }
}

void closures_over_matrices_larger(const double a[4], const double b[4],
    double result[BESSEMER_RESTRICT 4])
{
    for (uint32_t i = 0U; i < 4U; i++) {
        result[i] = max_f64(a[i], b[i]);
    }
}

void closures_over_matrices_step(double position[BESSEMER_RESTRICT 3], const double goal[3],
    double most)
{
    for (uint32_t i = 0U; i < 3U; i++) {
        const double way = goal[i] - position[i];
        double x_choice;
        if (way > most) {
            x_choice = most;
        } else {
            x_choice = way;
        }
        position[i] += x_choice;
    }
}

uint32_t closures_over_matrices_rounded(float a[8])
{
    for (uint32_t i = 0U; i < 8U; i++) {
        a[i] = floorf(a[i]);
    }
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < 8U; i++) {
        if (a[i] < 0.0F) {
            count += 1U;
        }
    }
    return count;
}

void closures_over_matrices_second_difference(double result[16])
{
    for (uint32_t column = 0U; column < 4U; column++) {
        for (uint32_t row = 0U; row < 4U; row++) {
            if (row == column) {
                result[row + 4U * column] = 2.0;
            } else if (row + 1U == column || column + 1U == row) {
                result[row + 4U * column] = -1.0;
            } else {
                result[row + 4U * column] = 0.0;
            }
        }
    }
}

void closures_over_matrices_faded(const double a[9], double result[BESSEMER_RESTRICT 9])
{
    for (uint32_t column = 0U; column < 3U; column++) {
        for (uint32_t row = 0U; row < 3U; row++) {
            if (row > column) {
                result[row + 3U * column] = a[row + 3U * column]
                    / (f64_from_u32(row - column) + 1.0);
            } else {
                result[row + 3U * column] = a[row + 3U * column];
            }
        }
    }
}

void closures_over_matrices_inner(const double a[4], const double b[4],
    pair_f64_f64_t *BESSEMER_RESTRICT result)
{
    double both = 0.0;
    for (uint32_t i = 0U; i < 4U; i++) {
        both += a[i] * b[i];
    }
    double squares = -0.0;
    for (uint32_t i = 0U; i < 4U; i++) {
        squares += a[i] * a[i];
    }
    result->first = both;
    result->second = squares;
}

bessemer_status_t closures_over_matrices_element(const double a[9], uint64_t index,
    double *BESSEMER_RESTRICT result)
{
    if (index >= UINT64_C(9)) {
        return BESSEMER_STATUS_INDEX;
    }
    *result = a[index];
    return BESSEMER_STATUS_OK;
}
