/* The C of tests/corpus/src/programs/control/for_steps.rs. Written by a test. */

/* for_steps.c */

static const uint64_t U64_MAX = UINT64_MAX;

double for_steps_interleaved(const double values[10])
{
    double sum = 0.0;
    for (uint32_t pass = 0U; pass < 5U; pass++) {
        const uint32_t i = pass * 2U;
        sum += values[i];
    }
    for (uint32_t pass = 5U; pass-- > 0U;) {
        const uint32_t i = 1U + pass * 2U;
        sum = 0.5 * sum + values[i];
    }
    return sum;
}

uint32_t for_steps_thirds(uint8_t from, uint8_t to)
{
    uint32_t sum = 0U;
    const uint8_t n_length = saturating_sub_u8(to, from);
    const uint8_t n_passes = (uint8_t)((uint32_t)n_length / 3U + (uint32_t)(n_length % 3U != 0U));
    for (uint8_t pass = 0U; pass < n_passes; pass++) {
        const uint8_t n = (uint8_t)((uint32_t)from + (uint32_t)pass * 3U);
        sum += (uint32_t)n;
    }
    return sum;
}

bessemer_status_t for_steps_every(const double values[10], uint64_t count, uint64_t step,
    double *BESSEMER_RESTRICT sum)
{
    double sum_value = 0.0;
    const uint32_t i_end = (uint32_t)min_u64(count, UINT64_C(10));
    if (step == UINT64_C(0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    const uint64_t i_passes = i_end / step + (uint64_t)(i_end % step != UINT64_C(0));
    for (uint64_t pass = UINT64_C(0); pass < i_passes; pass++) {
        const uint64_t i = pass * step;
        if (i >= UINT64_C(10)) {
            return BESSEMER_STATUS_INDEX;
        }
        sum_value += values[i];
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t for_steps_signed(int8_t low, int8_t high, uint64_t step, int32_t *sum)
{
    int32_t sum_value = 0;
    if (step == UINT64_C(0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    const uint64_t x_passes = (uint64_t)max_i64((int64_t)high - (int64_t)low, INT64_C(0)) / step
        + (uint64_t)(low <= high);
    for (uint64_t pass = UINT64_C(0); pass < x_passes; pass++) {
        const int8_t x = wrap_i8((uint8_t)((uint64_t)low + pass * step));
        sum_value = sum_value / 2 + (int32_t)x;
    }
    const uint64_t x_length = (uint64_t)max_i64((int64_t)high - (int64_t)low, INT64_C(0));
    const uint64_t x_passes_2 = x_length / UINT64_C(3)
        + (uint64_t)(x_length % UINT64_C(3) != UINT64_C(0));
    for (uint64_t pass = x_passes_2; pass-- > UINT64_C(0);) {
        const int8_t x = wrap_i8((uint8_t)((uint64_t)low + pass * UINT64_C(3)));
        sum_value = sum_value / 2 - (int32_t)x;
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t for_steps_late(uint64_t from, uint64_t step, uint64_t *last)
{
    uint64_t last_value = UINT64_C(0);
    const uint64_t n_end = saturating_add_u64(from, UINT64_C(9));
    if (step == UINT64_C(0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    const uint64_t n_passes = saturating_add_u64(saturating_sub_u64(n_end, from) / step,
        (uint64_t)(from <= n_end));
    for (uint64_t pass = UINT64_C(0); pass < n_passes; pass++) {
        const uint64_t n = from + pass * step;
        last_value = n;
    }
    const uint64_t n_length = saturating_sub_u64(saturating_add_u64(from, UINT64_C(9)), from);
    const uint64_t n_passes_2 = n_length / step + (uint64_t)(n_length % step != UINT64_C(0));
    for (uint64_t pass = UINT64_C(0); pass < n_passes_2; pass++) {
        const uint64_t n = from + pass * step;
        last_value ^= n;
    }
    *last = last_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t for_steps_negative(int32_t from, uint8_t width, int32_t *result)
{
    const int32_t from_2 = clamp_i32(from, -1000, 1000);
    int32_t sum = 0;
    for (uint32_t pass = 0U; pass < 5U; pass++) {
        const int32_t x = wrap_i32((uint32_t)((uint64_t)(-9) + (uint64_t)pass * UINT64_C(4)));
        if ((int64_t)sum + (int64_t)x < INT32_MIN || (int64_t)sum + (int64_t)x > INT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        sum += x;
    }
    int32_t sum_2 = 0;
    const int32_t i_end = from_2 + (int32_t)width;
    const uint64_t i_length = (uint64_t)max_i64((int64_t)i_end - (int64_t)from_2, INT64_C(0));
    const uint64_t i_passes = i_length / UINT64_C(5)
        + (uint64_t)(i_length % UINT64_C(5) != UINT64_C(0));
    for (uint64_t pass = UINT64_C(0); pass < i_passes; pass++) {
        const int32_t x = wrap_i32((uint32_t)((uint64_t)from_2 + pass * UINT64_C(5)));
        sum_2 += x % 7;
    }
    if ((int64_t)sum + (int64_t)sum_2 < INT32_MIN || (int64_t)sum + (int64_t)sum_2 > INT32_MAX) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    *result = sum + sum_2;
    return BESSEMER_STATUS_OK;
}

uint32_t for_steps_moved(uint8_t start)
{
    uint8_t end = 20U;
    uint32_t sum = 0U;
    const uint8_t n_end = end;
    end = 3U;
    const uint32_t n_choice = (uint32_t)end;
    const uint64_t n_length = (uint64_t)max_i64((int64_t)n_end - (int64_t)start, INT64_C(0));
    const uint64_t n_passes = n_length / n_choice + (uint64_t)(n_length % n_choice != 0U);
    for (uint64_t pass = UINT64_C(0); pass < n_passes; pass++) {
        const uint8_t n = (uint8_t)((uint64_t)start + pass * (uint64_t)n_choice);
        sum += (uint32_t)n;
    }
    return sum + (uint32_t)end;
}

bessemer_status_t for_steps_farthest(int64_t from, int64_t to, uint64_t step,
    pair_i64_u32_t *result)
{
    uint32_t passes = 0U;
    int64_t last = INT64_C(0);
    if (step == UINT64_C(0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    const uint64_t n_passes = saturating_add_u64(
        ((uint64_t)max_i64(from, to) - (uint64_t)from) / step, (uint64_t)(from <= to));
    for (uint64_t pass = UINT64_C(0); pass < n_passes; pass++) {
        const int64_t n = wrap_i64((uint64_t)from + pass * step);
        last = n;
        if (passes > 0xFFFFFFFEU) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        passes += 1U;
        if (passes == 50U) {
            break;
        }
    }
    const uint64_t n_length = (uint64_t)max_i64(from, to) - (uint64_t)from;
    const uint64_t n_passes_2 = n_length / step + (uint64_t)(n_length % step != UINT64_C(0));
    for (uint64_t pass = UINT64_C(0); pass < n_passes_2; pass++) {
        const int64_t n = wrap_i64((uint64_t)from + pass * step);
        last ^= n;
        if (passes > 0xFFFFFFFEU) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        passes += 1U;
        if (passes >= 100U) {
            break;
        }
    }
    result->first = last;
    result->second = passes;
    return BESSEMER_STATUS_OK;
}

uint64_t for_steps_all(uint64_t start)
{
    uint64_t sum = UINT64_C(0);
    const uint64_t n_passes = saturating_add_u64(saturating_sub_u64(U64_MAX, start) / UINT64_C(1),
        (uint64_t)(start <= U64_MAX));
    for (uint64_t pass = UINT64_C(0); pass < n_passes; pass++) {
        const uint64_t n = start + pass;
        sum += n;
        if (n % UINT64_C(16) == UINT64_C(7)) {
            break;
        }
    }
    return sum;
}
