/* The C of tests/corpus/src/programs/numbers/checked.rs. Written by a test. */

/* programs_numbers_checked.c */

bessemer_status_t programs_numbers_checked_mean(uint16_t a, uint16_t b, uint16_t *result)
{
    if ((int64_t)a + (int64_t)b > INT64_C(65535)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    *result = (uint16_t)((uint16_t)(a + b) / 2U);
    return BESSEMER_STATUS_OK;
}

uint16_t programs_numbers_checked_mean_of_wide(uint16_t a, uint16_t b)
{
    return (uint16_t)(((uint32_t)a + (uint32_t)b) / 2U);
}
