/* The C of tests/corpus/src/programs/control/for_elements.rs. Written by a test. */

/* for_elements.c */

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
