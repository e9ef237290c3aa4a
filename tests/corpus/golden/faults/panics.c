/* The C of tests/corpus/src/programs/faults/panics.rs. Written by a test. */

/* panics.c */

bessemer_status_t panics_period(uint8_t prescaler, uint32_t *result)
{
    switch (prescaler) {
    case 0U:
        *result = 1U;
        return BESSEMER_STATUS_OK;
    case 1U:
        *result = 8U;
        return BESSEMER_STATUS_OK;
    case 2U:
        *result = 64U;
        return BESSEMER_STATUS_OK;
    case 3U:
        return BESSEMER_STATUS_ASSERTION;
    default:
        return BESSEMER_STATUS_ASSERTION;
    }
}

bessemer_status_t panics_larger(int32_t a, int32_t b, int32_t *larger)
{
    if (a == b) {
        return BESSEMER_STATUS_ASSERTION;
    }
    int32_t larger_value;
    if (a > b) {
        larger_value = a;
    } else {
        larger_value = b;
    }
    *larger = larger_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t panics_required(const option_f64_t *value, double *BESSEMER_RESTRICT result)
{
    if (!value->is_some) {
        return BESSEMER_STATUS_ASSERTION;
    }
    const double value_2 = value->value;
    if (value_2 > 0.0) {
        *result = value_2;
        return BESSEMER_STATUS_OK;
    } else {
        return BESSEMER_STATUS_ASSERTION;
    }
}
