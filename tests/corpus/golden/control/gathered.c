/* The C of tests/corpus/src/programs/control/gathered.rs. Written by a test. */

/* gathered.c */

void gathered_halve(double samples[5])
{
    for (uint32_t i = 0U; i < 5U; i++) {
        samples[i] *= 0.5;
    }
}

double gathered_moment(const double samples[5])
{
    double sum = 0.0;
    for (uint32_t place = 0U; place < 5U; place++) {
        if (place % 2U == 0U) {
            const double weight = (double)place;
            sum += weight * samples[place];
        }
    }
    return sum;
}

bessemer_status_t gathered_added(uint16_t sums[BESSEMER_RESTRICT 4], const uint8_t parts[3])
{
    for (uint32_t i = 0U; i < 3U; i++) {
        if ((int64_t)sums[i] + (int64_t)parts[i] > INT64_C(65535)) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        sums[i] = (uint16_t)(sums[i] + (uint16_t)parts[i]);
    }
    return BESSEMER_STATUS_OK;
}

void gathered_largest(const double values[4], uint64_t count,
    option_f64_t *BESSEMER_RESTRICT result)
{
    *result = (option_f64_t){.is_some = false};
    const uint32_t result_count = (uint32_t)min_u64(count, UINT64_C(4));
    for (uint32_t i = 0U; i < result_count; i++) {
        double reduced_choice;
        if (result->is_some) {
            const double gathered = result->value;
            reduced_choice = max_f64(gathered, values[i]);
        } else {
            reduced_choice = values[i];
        }
        result->is_some = true;
        result->value = reduced_choice;
    }
}

bessemer_status_t gathered_balance(const int32_t values[5], int32_t *BESSEMER_RESTRICT result)
{
    option_i32_t reduced = {.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        const int32_t x = values[i] / 2;
        int32_t reduced_choice;
        if (reduced.is_some) {
            const int32_t so_far = reduced.value;
            if (so_far > x) {
                if ((int64_t)so_far - (int64_t)x > INT32_MAX) {
                    return BESSEMER_STATUS_OVERFLOW;
                }
                reduced_choice = so_far - x;
            } else {
                if ((int64_t)so_far + (int64_t)x < INT32_MIN) {
                    return BESSEMER_STATUS_OVERFLOW;
                }
                reduced_choice = so_far + x;
            }
        } else {
            reduced_choice = x;
        }
        reduced.is_some = true;
        reduced.value = reduced_choice;
    }
    int32_t result_value = 0;
    if (reduced.is_some) {
        result_value = reduced.value;
    }
    *result = result_value;
    return BESSEMER_STATUS_OK;
}

void gathered_parity(uint8_t end, option_u8_t *result)
{
    *result = (option_u8_t){.is_some = false};
    for (uint8_t b = 0U; b < end; b++) {
        if (b % 3U == 1U) {
            uint8_t reduced_choice;
            if (result->is_some) {
                const uint8_t a = result->value;
                reduced_choice = (uint8_t)(a ^ b);
            } else {
                reduced_choice = b;
            }
            result->is_some = true;
            result->value = reduced_choice;
        }
    }
}

int32_t gathered_within(int32_t value, int32_t low, uint8_t high)
{
    return max_i32(low, min_i32(value, (int32_t)high));
}

int16_t gathered_positive(int16_t value)
{
    int16_t least = 0;
    least = max_i16(least, value);
    return min_i16(1000, least);
}
