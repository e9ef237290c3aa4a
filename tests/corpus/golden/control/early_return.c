/* The C of tests/corpus/src/programs/control/early_return.rs. Written by a test. */

/* early_return.c */

bessemer_status_t early_return_search(const uint16_t table[8], uint16_t wanted,
    uint64_t *BESSEMER_RESTRICT result)
{
    uint32_t low = 0U;
    uint32_t high = 8U;
    for (uint32_t pass = 0U; pass <= 4U; pass++) {
        if (low >= high) {
            break;
        }
        if (pass >= 4U) {
            return BESSEMER_STATUS_BOUND;
        }
        const uint32_t middle = (low + high) / 2U;
        if (table[middle] == wanted) {
            *result = middle;
            return BESSEMER_STATUS_OK;
        }
        if (table[middle] < wanted) {
            low = middle + 1U;
        } else {
            high = middle;
        }
    }
    *result = UINT64_C(8);
    return BESSEMER_STATUS_OK;
}
