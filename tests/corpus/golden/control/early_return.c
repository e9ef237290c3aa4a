/* The C of tests/corpus/src/programs/control/early_return.rs. Written by a test. */

/* early_return.c */

bessemer_status_t early_return_search(const uint16_t table[8], uint16_t wanted, uint64_t *result)
{
    uint64_t low = UINT64_C(0);
    uint32_t high = 8U;
    for (uint32_t pass = 0U; pass <= 4U; pass++) {
        if (low >= high) {
            break;
        }
        if (pass >= 4U) {
            return BESSEMER_STATUS_BOUND;
        }
        if (low > UINT64_MAX - (uint64_t)high) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        const uint64_t middle = (low + high) / UINT64_C(2);
        if (middle >= UINT64_C(8)) {
            return BESSEMER_STATUS_INDEX;
        }
        if (table[middle] == wanted) {
            *result = middle;
            return BESSEMER_STATUS_OK;
        }
        if (table[middle] < wanted) {
            low = middle + UINT64_C(1);
        } else {
            high = (uint32_t)middle;
        }
    }
    *result = UINT64_C(8);
    return BESSEMER_STATUS_OK;
}
