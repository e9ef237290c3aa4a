/* The C of tests/corpus/src/programs/cookbook/lookup_table.rs. Written by a test. */

/* lookup_table.c */

static const uint16_t BROKEN = 4000U;
static const uint16_t SHORTED = 100U;

void lookup_table_thermistor(uint16_t counts, option_f32_t *result)
{
    if (counts < SHORTED || counts > BROKEN) {
        *result = (option_f32_t){.is_some = false};
        return;
    }
    place_f32_t result_place;
    axis_f32_10_place(&LOOKUP_TABLE_NTC_COUNTS, (float)counts, BEYOND_HOLD, &result_place);
    const float result_value = tables_interpolated_f32_10(LOOKUP_TABLE_NTC_TEMPERATURES,
        &result_place);
    result->is_some = true;
    result->value = result_value;
}
