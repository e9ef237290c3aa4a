/* The C of tests/corpus/src/programs/control/counting_while.rs. Written by a test. */

/* counting_while.c */

uint64_t counting_while_quiet(const float samples[16], float limit)
{
    uint64_t count = UINT64_C(0);
    while (count < UINT64_C(16) && samples[count] < limit) {
        count += UINT64_C(1);
    }
    return count;
}

uint64_t counting_while_place(const float table[16], float x)
{
    uint64_t low = UINT64_C(0);
    uint64_t high = UINT64_C(16);
    while (low < high) {
        const uint64_t middle = (low + high) / UINT64_C(2);
        if (table[middle] <= x) {
            low = middle + UINT64_C(1);
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
