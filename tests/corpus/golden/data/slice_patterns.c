/* The C of tests/corpus/src/programs/data/slice_patterns.rs. Written by a test. */

/* slice_patterns.c */

static void slice_patterns_span_of(const float values[], uint64_t values_length,
    option_f32_t *BESSEMER_RESTRICT result);
static int16_t slice_patterns_largest(const int16_t values[], uint64_t values_length);

void slice_patterns_decoded(const uint8_t bytes[6], pair_u8_u32_t *BESSEMER_RESTRICT result)
{
    uint32_t sum = 0U;
    for (uint32_t i = 1U; i < 6U; i++) {
        sum += (uint32_t)bytes[i];
    }
    result->first = bytes[0];
    result->second = sum;
}

/** The span of some values; `None` if there are none. */
static void slice_patterns_span_of(const float values[], uint64_t values_length,
    option_f32_t *BESSEMER_RESTRICT result)
{
    if (values_length == UINT64_C(0)) {
        *result = (option_f32_t){.is_some = false};
    } else if (values_length == UINT64_C(1)) {
        result->is_some = true;
        result->value = 0.0F;
    } else {
        result->is_some = true;
        result->value = values[values_length - UINT64_C(1)] - values[0];
    }
}

bessemer_status_t slice_patterns_span(const float values[4], uint64_t end,
    option_f32_t *BESSEMER_RESTRICT result)
{
    if (end > UINT64_C(4)) {
        return BESSEMER_STATUS_INDEX;
    }
    slice_patterns_span_of(values, end, result);
    return BESSEMER_STATUS_OK;
}

/** The largest of some values. */
static int16_t slice_patterns_largest(const int16_t values[], uint64_t values_length)
{
    if (values_length >= UINT64_C(2)) {
        int16_t most = max_i16(values[0], values[values_length - UINT64_C(1)]);
        for (uint64_t i = UINT64_C(1); i < values_length - UINT64_C(1) - UINT64_C(1) + UINT64_C(1);
                i++) {
            most = max_i16(most, values[i]);
        }
        return most;
    }
    option_i16_t result_found = {.is_some = false};
    if (values_length > UINT64_C(0)) {
        result_found.is_some = true;
        result_found.value = values[0];
    }
    int16_t result = 0;
    if (result_found.is_some) {
        result = result_found.value;
    }
    return result;
}

bessemer_status_t slice_patterns_largest_from(const int16_t values[5], uint64_t start,
    int16_t *BESSEMER_RESTRICT result)
{
    if (start > UINT64_C(5)) {
        return BESSEMER_STATUS_INDEX;
    }
    *result = slice_patterns_largest(&values[start], UINT64_C(5) - start);
    return BESSEMER_STATUS_OK;
}

void slice_patterns_tail(const int32_t values[4], int32_t rest[BESSEMER_RESTRICT 3])
{
    rest[0] = values[1];
    rest[1] = values[2];
    rest[2] = values[3];
}
