/* The C of tests/corpus/src/programs/data/tables.rs. Written by a test. */

/* programs_data_tables.c */

static const float FUEL[9] = {0.0F, 1.5F, 3.5F, 6.0F, 9.0F, 12.5F, 16.5F, 21.0F, 26.0F};
static const uint64_t LAST = UINT64_C(7);
static const float STEP = 0.625F;

float programs_data_tables_fuel(float voltage)
{
    const float place = clamp_f32(voltage / STEP, 0.0F, 8.0F);
    const uint32_t at = (uint32_t)min_u64(u64_from_f32(place), LAST);
    return FUEL[at] + (FUEL[at + 1U] - FUEL[at]) * (place - (float)at);
}
