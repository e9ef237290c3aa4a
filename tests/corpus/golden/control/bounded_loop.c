/* The C of tests/corpus/src/programs/control/bounded_loop.rs. Written by a test. */

/* bounded_loop.c */

bessemer_status_t bounded_loop_root(uint32_t n, uint32_t *root)
{
    if (n < 2U) {
        *root = n;
        return BESSEMER_STATUS_OK;
    }
    uint32_t guess = n / 2U;
    uint32_t root_value = 0U;
    for (uint32_t pass = 0U; pass <= 32U; pass++) {
        if (pass >= 32U) {
            return BESSEMER_STATUS_BOUND;
        }
        if (guess == 0U) {
            return BESSEMER_STATUS_DIVISION_BY_ZERO;
        }
        if ((int64_t)guess + i64_from_u32(n / guess) > (int64_t)UINT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        const uint32_t next = (guess + n / guess) / 2U;
        if (next >= guess) {
            root_value = guess;
            break;
        }
        guess = next;
    }
    *root = root_value;
    return BESSEMER_STATUS_OK;
}
