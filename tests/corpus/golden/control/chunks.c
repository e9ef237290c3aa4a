/* The C of tests/corpus/src/programs/control/chunks.rs. Written by a test. */

/* chunks.c */

double chunks_busiest(const double values[8])
{
    double most = -DBL_MAX;
    for (uint32_t i = 0U; i < 3U; i++) {
        const uint32_t value_end = (uint32_t)min_u64(u64_from_u32(i * 3U + 3U), UINT64_C(8));
        double sum = -0.0;
        for (uint32_t j = i * 3U; j < value_end; j++) {
            sum += values[j];
        }
        most = max_f64(most, sum);
    }
    return most;
}

bessemer_status_t chunks_passed(const uint8_t bytes[10], uint64_t used, uint32_t limit,
    option_usize_t *BESSEMER_RESTRICT result)
{
    const uint32_t used_2 = (uint32_t)min_u64(used, UINT64_C(10));
    uint32_t sum = 0U;
    for (uint32_t block = 0U; block < (used_2 + 3U) / 4U; block++) {
        if (block * 4U > used_2) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        const uint32_t value_length = (uint32_t)min_u64(UINT64_C(4),
            u64_from_u32(used_2 - block * 4U));
        for (uint32_t i = block * 4U; i < block * 4U + value_length; i++) {
            if (i >= 10U) {
                return BESSEMER_STATUS_INDEX;
            }
            if ((int64_t)sum + (int64_t)bytes[i] > (int64_t)UINT32_MAX) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            sum += (uint32_t)bytes[i];
        }
        if (sum > limit) {
            result->is_some = true;
            result->value = block;
            return BESSEMER_STATUS_OK;
        }
    }
    *result = (option_usize_t){.is_some = false};
    return BESSEMER_STATUS_OK;
}

bessemer_status_t chunks_leading_number(const uint8_t text[6],
    option_u16_t *BESSEMER_RESTRICT result)
{
    uint16_t number = 0U;
    for (uint32_t i = 0U; i < 6U; i++) {
        if (!ascii_is_digit(text[i])) {
            break;
        }
        option_u16_t number_option;
        math_checked_mul_u16(number, 10U, &number_option);
        if (!number_option.is_some) {
            *result = (option_u16_t){.is_some = false};
            return BESSEMER_STATUS_OK;
        }
        if (text[i] < 48U) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        option_u16_t number_option_2;
        math_checked_add_u16(number_option.value, (uint16_t)(uint8_t)(text[i] - 48U),
            &number_option_2);
        if (!number_option_2.is_some) {
            *result = (option_u16_t){.is_some = false};
            return BESSEMER_STATUS_OK;
        }
        number = number_option_2.value;
    }
    result->is_some = true;
    result->value = number;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t chunks_first_run(const int32_t values[8], int32_t limit,
    int32_t *BESSEMER_RESTRICT result)
{
    int32_t sum = 0;
    for (uint32_t i = 0U; i < 8U; i++) {
        if (values[i] <= limit) {
            break;
        }
        if (values[i] <= 100) {
            if ((int64_t)sum + (int64_t)values[i] < INT32_MIN
                    || (int64_t)sum + (int64_t)values[i] > INT32_MAX) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            sum += values[i];
        }
    }
    *result = sum;
    return BESSEMER_STATUS_OK;
}
