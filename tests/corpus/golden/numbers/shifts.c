/* The C of tests/corpus/src/programs/numbers/shifts.rs. Written by a test. */

/* shifts.c */

bessemer_status_t shifts_field(uint32_t word, uint32_t first, uint32_t width, uint32_t *result)
{
    if (first >= 32U) {
        return BESSEMER_STATUS_SHIFT;
    }
    if (width >= 32U) {
        return BESSEMER_STATUS_SHIFT;
    }
    *result = (word >> first) & (((uint32_t)1U << width) - 1U);
    return BESSEMER_STATUS_OK;
}

uint16_t shifts_middle(uint32_t word)
{
    return (uint16_t)(word >> 8);
}

int16_t shifts_halved(int16_t n)
{
    return shift_right_i16(n, 1U);
}
