/* The C of tests/corpus/src/programs/faults/division.rs. Written by a test. */

/* division.c */

bessemer_status_t division_rate(int32_t count, int32_t period, int32_t *result)
{
    if (period == 0) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    if (count == INT32_MIN && period == -1) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    *result = count / period;
    return BESSEMER_STATUS_OK;
}

uint32_t division_safe_rate(uint32_t count, uint32_t period)
{
    return count / max_u32(period, 1U);
}
