/* The C of tests/corpus/src/programs/control/for_ranges.rs. Written by a test. */

/* for_ranges.c */

void for_ranges_window(const int16_t values[8], int32_t result[BESSEMER_RESTRICT 2])
{
    int32_t sum = 0;
    int32_t negative = 0;
    for (uint32_t i = 0U; i < 8U; i++) {
        sum += (int32_t)values[i];
        if (values[i] < 0) {
            negative += 1;
        }
    }
    result[0] = sum;
    result[1] = negative;
}

uint32_t for_ranges_falling(uint32_t n, uint8_t k)
{
    uint32_t product = 1U;
    for (uint32_t i = 0U; i < (uint32_t)k; i++) {
        product *= n - i;
    }
    return product;
}
