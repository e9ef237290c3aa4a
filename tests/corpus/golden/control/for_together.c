/* The C of tests/corpus/src/programs/control/for_together.rs. Written by a test. */

/* for_together.c */

double for_together_weighted(const double values[5], const double weights[5])
{
    double sum = 0.0;
    for (uint32_t i = 0U; i < 5U; i++) {
        sum += values[i] * weights[i];
    }
    return sum;
}

uint64_t for_together_first_above(const int32_t values[6], int32_t limit)
{
    for (uint32_t i = 0U; i < 6U; i++) {
        if (values[i] > limit) {
            return i;
        }
    }
    return UINT64_C(6);
}
