/* The C of tests/corpus/src/programs/data/tables.rs. Written by a test. */

/* tables.c */

static const float FUEL[9] = {0.0F, 1.5F, 3.5F, 6.0F, 9.0F, 12.5F, 16.5F, 21.0F, 26.0F};
static const uint64_t LAST = UINT64_C(7);
static const float STEP = 0.625F;

/* The smaller of two integers. */
static uint64_t min_u64(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

/* The number nearest to value from low to high; NaN stays NaN. */
static float clamp_f32(float value, float low, float high)
{
    if (value < low) {
        return low;
    }
    return value > high ? high : value;
}

/* The integer nearest to value towards zero, within its type; 0 for a NaN. */
static uint64_t u64_from_f32(float value)
{
    if (isnan(value)) {
        return 0;
    }
    if (value <= 0.0F) {
        return 0;
    }
    return value >= 18446744073709551616.0F ? UINT64_MAX : (uint64_t)value;
}

float tables_fuel(float voltage)
{
    const float place = clamp_f32(voltage / STEP, 0.0F, 8.0F);
    const uint64_t at = min_u64(u64_from_f32(place), LAST);
    return FUEL[at] + (FUEL[at + UINT64_C(1)] - FUEL[at]) * (place - (float)at);
}
