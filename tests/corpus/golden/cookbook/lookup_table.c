/* The C of tests/corpus/src/programs/cookbook/lookup_table.rs. Written by a test. */

/* lookup_table.c */

static const uint16_t BROKEN = 4000U;
static const uint16_t SHORTED = 100U;

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

/**
 * The index of the first element for which `is_first` does not hold; it must hold for all elements before.
 */
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
        if (value <= place) {
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
    result->value = lookup_table_interpolated_10(LOOKUP_TABLE_NTC_COUNTS,
        LOOKUP_TABLE_NTC_TEMPERATURES, (float)counts);
}
