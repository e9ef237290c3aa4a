/* The C of tests/corpus/src/programs/matrices/named_views.rs. Written by a test. */

/* named_views.c */

void named_views_advance(double state[BESSEMER_RESTRICT 6], const double acceleration[3],
    double period)
{
    const double way_product = 0.5 * period * period;
    const double way[3] = {
        state[3] * period + acceleration[0] * way_product,
        state[4] * period + acceleration[1] * way_product,
        state[5] * period + acceleration[2] * way_product
    };
    double position[3] = {state[0], state[1], state[2]};
    position[0] += way[0];
    position[1] += way[1];
    position[2] += way[2];
    for (uint32_t row = 0U; row < 3U; row++) {
        state[row] = position[row];
    }
    double velocity[3] = {state[3], state[4], state[5]};
    velocity[0] += acceleration[0] * period;
    velocity[1] += acceleration[1] * period;
    velocity[2] += acceleration[2] * period;
    for (uint32_t row = 0U; row < 3U; row++) {
        state[row + 3U] = velocity[row];
    }
}

double named_views_changed(double covariance[BESSEMER_RESTRICT 16], const double noise[4],
    double least)
{
    double block[4] = {
        covariance[0 + 4 * 2], covariance[1 + 4 * 2],
        covariance[0 + 4 * 3], covariance[1 + 4 * 3]
    };
    block[0 + 2 * 0] += noise[0 + 2 * 0];
    block[1 + 2 * 0] += noise[1 + 2 * 0];
    block[0 + 2 * 1] += noise[0 + 2 * 1];
    block[1 + 2 * 1] += noise[1 + 2 * 1];
    for (uint32_t column = 0U; column < 2U; column++) {
        for (uint32_t row = 0U; row < 2U; row++) {
            covariance[row + 4U * (column + 2U)] = block[row + 2U * column];
        }
    }
    double block_2[4] = {
        covariance[0 + 4 * 2], covariance[1 + 4 * 2],
        covariance[0 + 4 * 3], covariance[1 + 4 * 3]
    };
    block_2[0 + 2 * 0] *= 2.0;
    block_2[1 + 2 * 0] *= 2.0;
    block_2[0 + 2 * 1] *= 2.0;
    block_2[1 + 2 * 1] *= 2.0;
    for (uint32_t column = 0U; column < 2U; column++) {
        for (uint32_t row = 0U; row < 2U; row++) {
            covariance[row + 4U * (column + 2U)] = block_2[row + 2U * column];
        }
    }
    if (covariance[0 + 4 * 2] < least) {
        covariance[0 + 4 * 2] = least;
    }
    const double result_a[4] = {
        covariance[0 + 4 * 2], covariance[1 + 4 * 2],
        covariance[0 + 4 * 3], covariance[1 + 4 * 3]
    };
    return parts_trace_f64_2(result_a);
}

bessemer_status_t named_views_up_to(double m[BESSEMER_RESTRICT 16], uint64_t column,
    const double by[4], double most, option_f64_t *BESSEMER_RESTRICT result)
{
    if (column > UINT64_C(0xFFFFFFFFFFFFFFFE)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (column + UINT64_C(1) > UINT64_C(4)) {
        return BESSEMER_STATUS_INDEX;
    }
    double part[4] = {
        m[0U + 4U * column], m[1U + 4U * column], m[2U + 4U * column], m[3U + 4U * column]
    };
    part[0] += by[0];
    part[1] += by[1];
    part[2] += by[2];
    part[3] += by[3];
    for (uint32_t row = 0U; row < 4U; row++) {
        m[row + 4U * (uint32_t)column] = part[row];
    }
    option_f64_t first_choice;
    const option_f64_t first_option = {.is_some = true, .value = m[0U + 4U * column]};
    if (first_option.value <= most) {
        first_choice.is_some = true;
        first_choice.value = first_option.value;
    } else {
        first_choice = (option_f64_t){.is_some = false};
    }
    if (!first_choice.is_some) {
        *result = (option_f64_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    const double first = first_choice.value;
    double part_2[4] = {
        m[0U + 4U * column], m[1U + 4U * column], m[2U + 4U * column], m[3U + 4U * column]
    };
    part_2[0] *= first;
    part_2[1] *= first;
    part_2[2] *= first;
    part_2[3] *= first;
    for (uint32_t row = 0U; row < 4U; row++) {
        m[row + 4U * (uint32_t)column] = part_2[row];
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        if (i == 2U) {
            continue;
        }
        m[i + 4U * (uint32_t)column] -= by[i];
    }
    const double result_a[4] = {
        m[0U + 4U * column], m[1U + 4U * column], m[2U + 4U * column], m[3U + 4U * column]
    };
    result->is_some = true;
    result->value = matrix_statistics_sum_f64_4_1(result_a);
    return BESSEMER_STATUS_OK;
}

void named_views_scaled(double m[BESSEMER_RESTRICT 6], const double by[2])
{
    for (uint32_t column = 0U; column < 3U; column++) {
        double column_2[2] = {m[0U + 2U * column], m[1U + 2U * column]};
        column_2[0] += by[0];
        column_2[1] += by[1];
        for (uint32_t row = 0U; row < 2U; row++) {
            m[row + 2U * column] = column_2[row];
        }
        m[1U + 2U * column] = 0.5;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        double row[3] = {m[i + 2U * 0U], m[i + 2U * 1U], m[i + 2U * 2U]};
        row[0] *= by[i];
        row[1] *= by[i];
        row[2] *= by[i];
        for (uint32_t column = 0U; column < 3U; column++) {
            m[i + 2U * column] = row[column];
        }
    }
}

double named_views_by_methods(double m[BESSEMER_RESTRICT 9], const double v[3], const double a[4])
{
    double part[3] = {m[0 + 3 * 0], m[1 + 3 * 0], m[2 + 3 * 0]};
    const double length = norms_normalize_mut_f64_3_1(part);
    for (uint32_t row = 0U; row < 3U; row++) {
        m[row + 3U * 0U] = part[row];
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        m[i + 3U * 1U] += v[i];
    }
    double part_2[4] = {
        m[1 + 3 * 1], m[2 + 3 * 1],
        m[1 + 3 * 2], m[2 + 3 * 2]
    };
    blas_gemm_f64_2_2_2(part_2, 2.0, a, a, 0.5);
    for (uint32_t column = 0U; column < 2U; column++) {
        for (uint32_t row = 0U; row < 2U; row++) {
            m[row + 1U + 3U * (column + 1U)] = part_2[row + 2U * column];
        }
    }
    m[2 + 3 * 0] = length;
    m[1 + 3 * 2] += v[0];
    for (uint32_t i = 0U; i < 3U; i++) {
        m[0U + 3U * i] *= 0.5;
    }
    return length;
}

void named_views_lengths(const float m[9], pair_f32_f32_t *BESSEMER_RESTRICT result)
{
    float columns = -0.0F;
    for (uint32_t column = 0U; column < 3U; column++) {
        const float column_2[3] = {m[0U + 3U * column], m[1U + 3U * column], m[2U + 3U * column]};
        columns += sqrtf(column_2[0] * column_2[0] + column_2[1] * column_2[1]
            + column_2[2] * column_2[2]);
    }
    float gathered = 0.0F;
    for (uint32_t row = 0U; row < 3U; row++) {
        const float row_2[3] = {m[row + 3U * 0U], m[row + 3U * 1U], m[row + 3U * 2U]};
        gathered = max_f32(gathered, larger_magnitude_f32(
            larger_magnitude_f32(fabsf(row_2[0]), fabsf(row_2[1])), fabsf(row_2[2])));
    }
    result->first = columns;
    result->second = gathered;
}

/* named_views_filter.c */

void filter_init(filter_t *self)
{
    for (uint32_t i = 0U; i < 16U; i++) {
        self->covariance[i] = 0.0;
    }
    self->noise[0] = 0.0;
    self->noise[1] = 0.0;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t filter_grow(filter_t *BESSEMER_RESTRICT self, uint64_t from, double limit,
    uint32_t *BESSEMER_RESTRICT count)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    uint32_t count_value = 0U;
    if (from > UINT64_C(0xFFFFFFFFFFFFFFFD)) {
        self->fault = BESSEMER_STATUS_OVERFLOW;
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (from + UINT64_C(2) > UINT64_C(4)) {
        self->fault = BESSEMER_STATUS_INDEX;
        return BESSEMER_STATUS_INDEX;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        self->covariance[from + i + 4U * (from + i)] += self->noise[i];
        if (self->covariance[from + i + 4U * (from + i)] > limit) {
            count_value += 1U;
        }
    }
    self->noise[0] += 0.125;
    self->covariance[0 + 4 * 3] = (double)count_value;
    *count = count_value;
    return BESSEMER_STATUS_OK;
}

/* named_views_filter.h */

/** A view next to another field of the same struct. */
typedef struct {
    /** A matrix by columns: [row + 4 * column]. */
    double covariance[16];
    double noise[2];
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} filter_t;
