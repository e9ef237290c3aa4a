/* The C of tests/corpus/src/programs/numbers/bytes.rs. Written by a test. */

/* programs_numbers_bytes.c */

void programs_numbers_bytes_head(uint16_t sequence, float value, uint8_t result[6])
{
    const uint8_t elements[2] = {(uint8_t)(sequence >> 8U), (uint8_t)sequence};
    const uint32_t value_value = bits_of_f32(value);
    const uint8_t elements_2[4] = {
        (uint8_t)value_value, (uint8_t)(value_value >> 8U), (uint8_t)(value_value >> 16U),
        (uint8_t)(value_value >> 24U)
    };
    result[0] = elements[0];
    result[1] = elements[1];
    result[2] = elements_2[0];
    result[3] = elements_2[1];
    result[4] = elements_2[2];
    result[5] = elements_2[3];
}

float programs_numbers_bytes_value(const uint8_t head[6])
{
    const uint8_t result_bytes[4] = {head[2], head[3], head[4], head[5]};
    return f32_from_bits((uint32_t)result_bytes[0] | ((uint32_t)result_bytes[1] << 8U)
        | ((uint32_t)result_bytes[2] << 16U) | ((uint32_t)result_bytes[3] << 24U));
}
