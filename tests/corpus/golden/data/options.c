/* The C of tests/corpus/src/programs/data/options.rs. Written by a test. */

/* programs_data_options.c */

void programs_data_options_slope(const double from[2], const double to[2],
    option_f64_t *BESSEMER_RESTRICT result)
{
    const double run = to[0] - from[0];
    if (run == 0.0) {
        *result = (option_f64_t){.is_some = false};
    } else {
        result->is_some = true;
        result->value = (to[1] - from[1]) / run;
    }
}

double programs_data_options_slope_or(const double from[2], const double to[2], double other)
{
    option_f64_t option;
    programs_data_options_slope(from, to, &option);
    double result = other;
    if (option.is_some) {
        result = option.value;
    }
    return result;
}

void programs_data_options_better(const option_u8_t *one, const option_u8_t *other,
    option_u8_t *BESSEMER_RESTRICT result)
{
    if (one->is_some && other->is_some) {
        const uint8_t a = one->value;
        const uint8_t b = other->value;
        result->is_some = true;
        result->value = max_u8(a, b);
    } else if (!other->is_some) {
        *result = *one;
    } else {
        *result = *other;
    }
}
