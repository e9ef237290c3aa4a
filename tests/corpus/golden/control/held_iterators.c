/* The C of tests/corpus/src/programs/control/held_iterators.rs. Written by a test. */

/* held_iterators.c */

bessemer_status_t held_iterators_made_before(const double samples[4], uint64_t n, bool is_asked,
    double *BESSEMER_RESTRICT sum)
{
    if (n < UINT64_C(1)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    const uint64_t below_end = n - UINT64_C(1);
    double sum_value = 0.0;
    if (is_asked) {
        for (uint64_t i = UINT64_C(0); i < below_end; i++) {
            sum_value += (double)i;
            if (sum_value > 100.0) {
                break;
            }
        }
        {
            const uint64_t end = UINT64_C(4) / n + min_u64(UINT64_C(4) % n, UINT64_C(1));
            for (uint64_t i = UINT64_C(0); i < end; i++) {
                const uint64_t samples_index = i * n;
                if (samples_index >= UINT64_C(4)) {
                    return BESSEMER_STATUS_INDEX;
                }
                sum_value += samples[samples_index];
            }
        }
        {
            const uint64_t end = UINT64_C(4) / n + min_u64(UINT64_C(4) % n, UINT64_C(1));
            for (uint64_t i = UINT64_C(0); i < end; i++) {
                const uint64_t product = i * n;
                if (product > UINT64_MAX - n) {
                    return BESSEMER_STATUS_OVERFLOW;
                }
                const uint32_t smaller = (uint32_t)min_u64(product + n, UINT64_C(4));
                const uint64_t product_2 = i * n;
                if (product_2 > smaller) {
                    return BESSEMER_STATUS_OVERFLOW;
                }
                if (smaller - product_2 == UINT64_C(0)) {
                    return BESSEMER_STATUS_INDEX;
                }
                const uint64_t samples_index = i * n;
                if (samples_index >= UINT64_C(4)) {
                    return BESSEMER_STATUS_INDEX;
                }
                sum_value += samples[samples_index];
            }
        }
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

int32_t held_iterators_changed_since(const int32_t samples[6], uint64_t first)
{
    uint32_t left = (uint32_t)(first & UINT64_C(3));
    const uint32_t count = left;
    const uint32_t count_2 = left + 2U;
    left += 3U;
    const uint32_t numbers_start = left;
    left = 0U;
    int32_t sum = (int32_t)left;
    const uint32_t value_count = (uint32_t)min_u64((uint64_t)count, UINT64_C(6));
    const uint32_t value_count_2 = (uint32_t)min_u64((uint64_t)count_2,
        u64_from_u32(6U - value_count));
    for (uint32_t i = value_count; i < value_count + value_count_2; i++) {
        sum = wrap_i32((uint32_t)sum + (uint32_t)samples[i]);
    }
    for (uint32_t number = numbers_start; number < 9U; number++) {
        sum = wrap_i32((uint32_t)sum * (uint32_t)(int32_t)number);
    }
    return sum;
}
