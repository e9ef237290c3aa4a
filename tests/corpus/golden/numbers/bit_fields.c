/* The C of tests/corpus/src/programs/numbers/bit_fields.rs. Written by a test. */

/* bit_fields.c */

uint16_t bit_fields_packed(uint8_t hours, uint8_t minutes, uint8_t seconds)
{
    return (uint16_t)((uint16_t)((uint16_t)((uint32_t)(uint16_t)((uint16_t)hours & 31U) << 11)
        | (uint16_t)((uint32_t)(uint16_t)((uint16_t)minutes & 63U) << 5))
        | (uint16_t)((uint16_t)((uint16_t)seconds / 2U) & 31U));
}

uint8_t bit_fields_hours(uint16_t time)
{
    return (uint8_t)(uint16_t)(time >> 11);
}
