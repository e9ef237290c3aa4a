/* The C of tests/corpus/src/programs/data/slices.rs. Written by a test. */

/* programs_data_slices.c */

double programs_data_slices_mean(const double values[], uint64_t values_length)
{
    if (values_length == UINT64_C(0)) {
        return 0.0;
    }
    double sum = 0.0;
    for (uint64_t i = UINT64_C(0); i < values_length; i++) {
        sum += values[i];
    }
    return sum / (double)values_length;
}

void programs_data_slices_centre(double values[], uint64_t values_length)
{
    const double mean = programs_data_slices_mean(values, values_length);
    for (uint64_t i = UINT64_C(0); i < values_length; i++) {
        values[i] -= mean;
    }
}

double programs_data_slices_trend(const double values[8])
{
    const double result_mean = programs_data_slices_mean(&values[4], UINT64_C(4));
    return result_mean - programs_data_slices_mean(values, UINT64_C(4));
}

bessemer_status_t programs_data_slices_window(const double values[8], uint64_t from,
    double *BESSEMER_RESTRICT result)
{
    double part[4];
    if (from > UINT64_C(0xFFFFFFFFFFFFFFFB)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (from + UINT64_C(4) > UINT64_C(8)) {
        return BESSEMER_STATUS_INDEX;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        part[i] = values[from + i];
    }
    programs_data_slices_centre(part, UINT64_C(4));
    *result = max_f64(fabs(part[0]), fabs(part[3]));
    return BESSEMER_STATUS_OK;
}

bessemer_status_t programs_data_slices_peak(const list6_f64_t *values, uint64_t end,
    option_f64_t *BESSEMER_RESTRICT result)
{
    if (end > min_u64(values->length, UINT64_C(6))) {
        return BESSEMER_STATUS_INDEX;
    }
    if (end <= UINT64_C(0)) {
        *result = (option_f64_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    double peak = values->items[0];
    for (uint64_t i = UINT64_C(1); i < end; i++) {
        peak = max_f64(peak, values->items[i]);
    }
    result->is_some = true;
    result->value = peak;
    return BESSEMER_STATUS_OK;
}
