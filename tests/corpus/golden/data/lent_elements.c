/* The C of tests/corpus/src/programs/data/lent_elements.rs. Written by a test. */

/* lent_elements.c */

static void lent_elements_halve_ends(float values[], uint64_t values_length);
static double lent_elements_above(const double values[], uint64_t values_length);

bool lent_elements_count(uint32_t counters[6], uint64_t number, uint32_t by)
{
    if (number >= UINT64_C(6)) {
        return false;
    }
    counters[number] = saturating_add_u32(counters[number], by);
    return true;
}

/** Halves the first and the last element. */
static void lent_elements_halve_ends(float values[], uint64_t values_length)
{
    if (values_length > UINT64_C(0)) {
        values[0] /= 2.0F;
    }
    if (values_length > UINT64_C(0)) {
        values[values_length - UINT64_C(1)] /= 2.0F;
    }
}

bessemer_status_t lent_elements_tapered(const float values[5], uint64_t end,
    float result[BESSEMER_RESTRICT 5])
{
    float own_values[5];
    (void)memcpy(own_values, values, sizeof(float[5]));
    if (end > UINT64_C(5)) {
        return BESSEMER_STATUS_INDEX;
    }
    lent_elements_halve_ends(own_values, end);
    (void)memcpy(result, own_values, sizeof(float[5]));
    return BESSEMER_STATUS_OK;
}

bessemer_status_t lent_elements_balance(const int16_t values[8], uint64_t middle,
    int32_t *BESSEMER_RESTRICT balance)
{
    if (middle > UINT64_C(8)) {
        return BESSEMER_STATUS_INDEX;
    }
    int32_t balance_value = 0;
    for (uint64_t i = middle; i < UINT64_C(8); i++) {
        balance_value += (int32_t)values[i];
    }
    for (uint64_t i = UINT64_C(0); i < middle; i++) {
        balance_value -= (int32_t)values[i];
    }
    *balance = balance_value;
    return BESSEMER_STATUS_OK;
}

void lent_elements_mirror(uint8_t values[8])
{
    for (uint32_t i = 0U; i < 4U; i++) {
        values[i + 4U] = (uint8_t)((uint32_t)values[i] * 2U);
    }
}

/** Amount by which the mean of the other values exceeds the first. */
static double lent_elements_above(const double values[], uint64_t values_length)
{
    if (values_length > UINT64_C(0)) {
        double sum = 0.0;
        for (uint64_t i = UINT64_C(1); i < values_length; i++) {
            sum += values[i] - values[0];
        }
        return sum;
    } else {
        return 0.0;
    }
}

bessemer_status_t lent_elements_above_from(const double values[6], uint64_t start,
    double *BESSEMER_RESTRICT result)
{
    if (start > UINT64_C(5)) {
        return BESSEMER_STATUS_INDEX;
    }
    *result = lent_elements_above(&values[start], UINT64_C(5) - start);
    return BESSEMER_STATUS_OK;
}
