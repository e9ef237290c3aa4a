/* The C of tests/corpus/src/programs/control/counting_while.rs. Written by a test. */

/* counting_while.c */

uint64_t counting_while_quiet(const float samples[16], float limit)
{
    uint32_t count = 0U;
    while (count < 16U && samples[count] < limit) {
        count += 1U;
    }
    return count;
}

uint64_t counting_while_place(const float table[16], float x)
{
    uint32_t low = 0U;
    uint32_t high = 16U;
    while (low < high) {
        const uint32_t middle = (low + high) / 2U;
        if (table[middle] <= x) {
            low = middle + 1U;
        } else {
            high = middle;
        }
    }
    return low;
}

uint32_t counting_while_divisor(uint32_t a, uint32_t b)
{
    uint32_t a_2 = a;
    uint32_t b_2 = b;
    while (b_2 != 0U) {
        const uint32_t rest = a_2 % b_2;
        a_2 = b_2;
        b_2 = rest;
    }
    return a_2;
}
