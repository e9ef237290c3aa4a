/* The C of tests/corpus/src/programs/cookbook/lookup_table.rs. Written by a test. */

/* lookup_table.c */

static const uint16_t BROKEN = 4000U;

/**
 * Counts of the converter, ascending: 10 kΩ at 25 °C with B = 3950 K, from the pin to ground, 10 kΩ to the reference.
 */
static const float NTC_COUNTS[10] = {
    160.2F, 267.1F, 461.7F, 707.1F, 1081.6F, 1419.1F, 1825.1F, 2278.4F, 2738.6F, 3157.0F
};

/** The temperature at each of these counts. Unit: °C. */
static const float NTC_TEMPERATURES[10] = {
    120.0F, 100.0F, 80.0F, 65.0F, 50.0F, 40.0F, 30.0F, 20.0F, 10.0F, 0.0F
};
static const uint16_t SHORTED = 100U;

/* The number nearest to value from low to high. */
static uint64_t clamp_u64(uint64_t value, uint64_t low, uint64_t high)
{
    if (value < low) {
        return low;
    }
    return value > high ? high : value;
}

/* The number nearest to value from low to high; NaN stays NaN. */
static float clamp_f32(float value, float low, float high)
{
    if (value < low) {
        return low;
    }
    return value > high ? high : value;
}

static uint64_t lookup_table_partition_point_in_interpolated_10(const float values[],
    uint64_t values_length, float place);

float lookup_table_interpolated_10(const float axis[10], const float values[10], float place)
{
    const uint64_t above = clamp_u64(
        lookup_table_partition_point_in_interpolated_10(axis, UINT64_C(10), place), UINT64_C(1),
        UINT64_C(9));
    const uint64_t below = above - UINT64_C(1);
    const float share = (place - axis[below]) / (axis[above] - axis[below]);
    return values[below] + clamp_f32(share, 0.0F, 1.0F) * (values[above] - values[below]);
}

/** The index of the first element that is not among the first ones. */
static uint64_t lookup_table_partition_point_in_interpolated_10(const float values[],
    uint64_t values_length, float place)
{
    uint64_t from = UINT64_C(0);
    uint64_t left = values_length;
    for (int32_t pass = 0; pass < 64; pass++) {
        const uint64_t middle = from + left / UINT64_C(2);
        if (left == UINT64_C(0) || middle >= values_length) {
            break;
        }
        const float value = values[middle];
        const bool is_first = value <= place;
        if (is_first) {
            from = middle + UINT64_C(1);
            left = left - left / UINT64_C(2) - UINT64_C(1);
        } else {
            left /= UINT64_C(2);
        }
    }
    return from;
}

void lookup_table_thermistor(uint16_t counts, option_f32_t *result)
{
    if (counts < SHORTED || counts > BROKEN) {
        result->is_some = false;
        result->value = 0.0F;
        return;
    }
    result->is_some = true;
    result->value = lookup_table_interpolated_10(NTC_COUNTS, NTC_TEMPERATURES, (float)counts);
}
