/* The C of tests/corpus/src/programs/control/chains.rs. Written by a test. */

/* programs_control_chains.c */

double programs_control_chains_power(const double samples[8])
{
    double sum = -0.0;
    for (uint32_t i = 0U; i < 8U; i++) {
        sum += samples[i] * samples[i];
    }
    return sum / 8.0;
}

bessemer_status_t programs_control_chains_weighted(const int32_t values[4],
    const int32_t weights[4], int32_t most, int32_t *BESSEMER_RESTRICT result)
{
    int32_t sum = 0;
    for (uint32_t i = 0U; i < 4U; i++) {
        if ((int64_t)values[i] * (int64_t)weights[i] < INT32_MIN
                || (int64_t)values[i] * (int64_t)weights[i] > INT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        const int32_t p = values[i] * weights[i];
        if (p <= most) {
            if ((int64_t)sum + (int64_t)p < INT32_MIN || (int64_t)sum + (int64_t)p > INT32_MAX) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            sum += p;
        }
    }
    *result = sum;
    return BESSEMER_STATUS_OK;
}

bool programs_control_chains_rises(const float values[5])
{
    bool every = true;
    for (uint32_t i = 1U; i < 5U; i++) {
        if (!(values[i] > values[i - 1U])) {
            every = false;
            break;
        }
    }
    return every;
}

uint8_t programs_control_chains_packed(const bool flags[8])
{
    uint8_t bits = 0U;
    for (uint32_t i = 0U; i < 8U; i++) {
        const bool flag = flags[i];
        if (flag) {
            bits = (uint8_t)(bits | ((uint32_t)1U << i));
        }
    }
    return bits;
}

bessemer_status_t programs_control_chains_factorial(uint64_t n, uint64_t *result)
{
    uint64_t product = UINT64_C(1);
    {
        const uint64_t end = min_u64(n, UINT64_C(25));
        bool more = UINT64_C(1) <= end;
        for (uint64_t i = UINT64_C(1); more; i = more ? i + 1U : i) {
            more = i < end;
            if (product > UINT64_MAX / i) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            product *= i;
        }
    }
    *result = product;
    return BESSEMER_STATUS_OK;
}
