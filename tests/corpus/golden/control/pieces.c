/* The C of tests/corpus/src/programs/control/pieces.rs. Written by a test. */

/* pieces.c */

bessemer_status_t pieces_butterflies(float data[8])
{
    uint32_t half = 1U;
    for (uint32_t pass = 0U; pass <= 3U; pass++) {
        if (half >= 8U) {
            break;
        }
        if (pass >= 3U) {
            return BESSEMER_STATUS_BOUND;
        }
        const uint32_t value_size = 2U * half;
        if (value_size == 0U) {
            return BESSEMER_STATUS_ASSERTION;
        }
        for (uint64_t i = UINT64_C(0); i < UINT64_C(8) / (uint64_t)value_size; i++) {
            if (half > value_size) {
                return BESSEMER_STATUS_INDEX;
            }
            {
                const uint32_t end = (uint32_t)min_u64(u64_from_u32(value_size - half),
                    (uint64_t)half);
                for (uint32_t j = 0U; j < end; j++) {
                    const uint64_t data_index = i * (uint64_t)value_size + j;
                    if (data_index >= UINT64_C(8)) {
                        return BESSEMER_STATUS_INDEX;
                    }
                    const uint64_t data_index_2 = i * (uint64_t)value_size + half + j;
                    if (data_index_2 >= UINT64_C(8)) {
                        return BESSEMER_STATUS_INDEX;
                    }
                    const float difference = data[data_index] - data[data_index_2];
                    const uint64_t data_index_3 = i * (uint64_t)value_size + half + j;
                    if (data_index_3 >= UINT64_C(8)) {
                        return BESSEMER_STATUS_INDEX;
                    }
                    const float a_operand = data[data_index_3];
                    const uint64_t data_index_4 = i * (uint64_t)value_size + j;
                    if (data_index_4 >= UINT64_C(8)) {
                        return BESSEMER_STATUS_INDEX;
                    }
                    const uint64_t data_index_5 = i * (uint64_t)value_size + j;
                    if (data_index_5 >= UINT64_C(8)) {
                        return BESSEMER_STATUS_INDEX;
                    }
                    data[data_index_5] = data[data_index_4] + a_operand;
                    const uint64_t data_index_6 = i * (uint64_t)value_size + half + j;
                    if (data_index_6 >= UINT64_C(8)) {
                        return BESSEMER_STATUS_INDEX;
                    }
                    data[data_index_6] = difference;
                }
            }
        }
        half *= 2U;
    }
    return BESSEMER_STATUS_OK;
}

bessemer_status_t pieces_read_again(float data[BESSEMER_RESTRICT 6], uint64_t at,
    float *BESSEMER_RESTRICT sum)
{
    if (at > UINT64_C(6)) {
        return BESSEMER_STATUS_INDEX;
    }
    float sum_value = 0.0F;
    {
        const uint64_t end = min_u64(UINT64_C(6) - at, at);
        for (uint64_t i = UINT64_C(0); i < end; i++) {
            data[at + i] *= 0.5F;
            const float a_operand = data[at + i];
            data[i] += a_operand;
            const float kept = data[at + i];
            sum_value += kept;
        }
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t pieces_sums(const int32_t values[], uint64_t values_length, uint64_t size,
    int32_t sums[BESSEMER_RESTRICT 4])
{
    int32_t sums_value[4] = {0, 0, 0, 0};
    if (size == UINT64_C(0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    const uint32_t smaller = (uint32_t)min_u64(values_length % size, UINT64_C(1));
    if (values_length / size > UINT64_MAX - (uint64_t)smaller) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    {
        const uint32_t end = (uint32_t)min_u64(values_length / size + smaller, UINT64_C(4));
        for (uint32_t i = 0U; i < end; i++) {
            const uint64_t value_length_product = (uint64_t)i * size;
            if (value_length_product > values_length) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            const uint64_t value_length = min_u64(size, values_length - value_length_product);
            const uint64_t product = (uint64_t)i * size;
            if (product > UINT64_MAX - value_length) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            for (uint64_t j = (uint64_t)i * size; j < product + value_length; j++) {
                if (j >= values_length) {
                    return BESSEMER_STATUS_INDEX;
                }
                sums_value[i] = wrap_i32((uint32_t)sums_value[i] + (uint32_t)values[j]);
            }
        }
    }
    sums[0] = sums_value[0];
    sums[1] = sums_value[1];
    sums[2] = sums_value[2];
    sums[3] = sums_value[3];
    return BESSEMER_STATUS_OK;
}

bessemer_status_t pieces_windows(const double values[6], uint64_t size,
    pair_f64_f64_t *BESSEMER_RESTRICT result)
{
    double most = 0.0;
    if (size == UINT64_C(0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    {
        const uint64_t end = max_u64(UINT64_C(6), size - UINT64_C(1)) - (size - UINT64_C(1));
        for (uint64_t i = UINT64_C(0); i < end; i++) {
            double sum = 0.0;
            if (i > UINT64_MAX - size) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            for (uint64_t j = i; j < i + size; j++) {
                if (j >= UINT64_C(6)) {
                    return BESSEMER_STATUS_INDEX;
                }
                sum += values[j];
            }
            most = max_f64(most, sum / (double)size);
        }
    }
    double some = 0.0;
    {
        const uint64_t end = UINT64_C(6) / size + min_u64(UINT64_C(6) % size, UINT64_C(1));
        for (uint64_t i = UINT64_C(0); i < end; i++) {
            const uint64_t values_index = i * size;
            if (values_index >= UINT64_C(6)) {
                return BESSEMER_STATUS_INDEX;
            }
            some += values[values_index];
        }
    }
    result->first = most;
    result->second = some;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t pieces_numbered(uint8_t data[7], uint64_t size)
{
    if (size == UINT64_C(0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    {
        const uint64_t end = UINT64_C(7) / size + min_u64(UINT64_C(7) % size, UINT64_C(1));
        for (uint64_t number = UINT64_C(0); number < end; number++) {
            const uint64_t product = number * size;
            if (product > UINT64_MAX - size) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            const uint32_t smaller = (uint32_t)min_u64(product + size, UINT64_C(7));
            const uint64_t product_2 = number * size;
            if (product_2 > smaller) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            if (smaller - product_2 == UINT64_C(0)) {
                return BESSEMER_STATUS_INDEX;
            }
            const uint64_t data_index = number * size;
            if (data_index >= UINT64_C(7)) {
                return BESSEMER_STATUS_INDEX;
            }
            data[data_index] = (uint8_t)number;
        }
    }
    return BESSEMER_STATUS_OK;
}
