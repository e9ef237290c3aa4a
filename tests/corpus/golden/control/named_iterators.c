/* The C of tests/corpus/src/programs/control/named_iterators.rs. Written by a test. */

/* named_iterators.c */

double named_iterators_spread(const double samples[8])
{
    double sum = -0.0;
    for (uint32_t i = 0U; i < 8U; i++) {
        sum += samples[i];
    }
    const double mean = sum / 8.0;
    const double count = 7.0;
    double sum_2 = -0.0;
    for (uint32_t i = 0U; i < 8U; i++) {
        sum_2 += (samples[i] - mean) * (samples[i] - mean);
    }
    return sum_2 / count;
}

void named_iterators_twice(const int32_t samples[5], int32_t least,
    pair_u32_i32_t *BESSEMER_RESTRICT result)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < 5U; i++) {
        if (samples[i] > least) {
            count += 1U;
        }
    }
    const uint32_t count_2 = count;
    int32_t sum = 0;
    for (uint32_t i = 0U; i < 5U; i++) {
        if (samples[i] > least) {
            sum = wrap_i32((uint32_t)sum + (uint32_t)samples[i]);
        }
    }
    result->first = count_2;
    result->second = sum;
}

uint32_t named_iterators_weighted(const uint16_t samples[6], const uint16_t weights[6])
{
    uint32_t sum = 0U;
    for (uint32_t i = 0U; i < 6U; i++) {
        sum += (uint32_t)samples[i] * (uint32_t)weights[i] / 4096U;
    }
    for (uint32_t i = 1U; i < 5U; i++) {
        sum += (uint32_t)samples[i];
    }
    return sum;
}

double named_iterators_shape(double x, bool up)
{
    if (x == 0.0) {
        return 1.0;
    } else if (x >= 1.0 && x <= 2.0 && up) {
        return 2.0 * x;
    } else if (!up && x < 0.0) {
        return 3.0;
    } else if (x == 4.0 || x == 5.0) {
        return 0.5;
    } else if (x < 1.0) {
        return -1.0;
    } else {
        return fabs(x);
    }
}

void named_iterators_magnitudes(int8_t x, int64_t y, pair_i8_i64_t *result)
{
    int64_t second;
    if (y < INT64_C(0)) {
        second = saturating_sub_i64(INT64_C(0), y);
    } else {
        second = y;
    }
    result->first = saturating_sub_i8(0, x);
    result->second = second;
}
