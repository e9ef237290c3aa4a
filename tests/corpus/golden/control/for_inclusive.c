/* The C of tests/corpus/src/programs/control/for_inclusive.rs. Written by a test. */

/* for_inclusive.c */

double for_inclusive_polynomial(const double coefficients[5], double x)
{
    double value = 0.0;
    for (uint32_t i = 5U; i-- > 0U;) {
        value = value * x + coefficients[i];
    }
    return value;
}

bessemer_status_t for_inclusive_triangle(uint8_t n, uint32_t *sum)
{
    uint32_t sum_value = 0U;
    for (uint32_t i = 1U; i <= (uint32_t)n; i++) {
        if ((int64_t)sum_value + (int64_t)i > (int64_t)UINT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        sum_value += i;
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}
