/* The C of tests/corpus/src/programs/data/several_at_once.rs. Written by a test. */

/* several_at_once.c */

uint32_t several_at_once_fibonacci(uint8_t n)
{
    uint32_t a = 0U;
    uint32_t b = 1U;
    for (uint8_t pass = 0U; pass < n; pass++) {
        const uint32_t a_next = b;
        const uint32_t b_next = a + b;
        a = a_next;
        b = b_next;
    }
    return a;
}

void several_at_once_ordered(double low, double high, pair_f64_f64_t *result)
{
    if (low > high) {
        const double low_next = high;
        const double high_next = low;
        low = low_next;
        high = high_next;
    }
    result->first = low;
    result->second = high;
}
