/* The C of tests/corpus/src/programs/numbers/bit_fields.rs. Written by a test. */

/* bit_fields.c */

uint16_t bit_fields_packed(uint8_t hours, uint8_t minutes, uint8_t seconds)
{
    return (uint16_t)((((uint32_t)hours & 0x1FU) << 11) | (((uint32_t)minutes & 0x3FU) << 5)
        | ((uint16_t)((uint16_t)seconds / 2U) & 0x1FU));
}

uint8_t bit_fields_hours(uint16_t time)
{
    return (uint8_t)(time >> 11);
}
