/* The C of tests/corpus/src/programs/faults/bounds.rs. Written by a test. */

/* bounds.c */

bessemer_status_t bounds_steps(uint16_t n, uint32_t *steps)
{
    uint64_t value = (uint64_t)n;
    uint32_t steps_value = 0U;
    for (uint32_t pass = 0U; pass <= 20U; pass++) {
        if (value <= UINT64_C(1)) {
            break;
        }
        if (pass >= 20U) {
            return BESSEMER_STATUS_BOUND;
        }
        if (value % UINT64_C(2) == UINT64_C(0)) {
            value /= UINT64_C(2);
        } else {
            if (value > UINT64_C(0x5555555555555555)) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            if (UINT64_C(3) * value > UINT64_C(0xFFFFFFFFFFFFFFFE)) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            value = UINT64_C(3) * value + UINT64_C(1);
        }
        steps_value += 1U;
    }
    *steps = steps_value;
    return BESSEMER_STATUS_OK;
}
