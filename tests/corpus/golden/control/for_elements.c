/* The C of tests/corpus/src/programs/control/for_elements.rs. Written by a test. */

/* for_elements.c */

/* The larger of two numbers: -0 < +0, and a NaN gives the other. */
static float max_f32(float a, float b)
{
    if (a > b || isnan(b)) {
        return a;
    }
    if (b > a || isnan(a)) {
        return b;
    }
    return !signbit(a) ? a : b;
}

float for_elements_largest(const float values[6])
{
    float most = values[0];
    for (uint32_t i = 0U; i < 6U; i++) {
        most = max_f32(most, values[i]);
    }
    return most;
}

uint8_t for_elements_checksum(const uint8_t bytes[7])
{
    uint8_t sum = 0U;
    for (uint32_t i = 0U; i < 7U; i++) {
        const uint8_t byte = bytes[i];
        sum = (uint8_t)(sum ^ byte);
    }
    return sum;
}
