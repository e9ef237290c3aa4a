/* The C of tests/corpus/src/programs/numbers/powers.rs. Written by a test. */

/* powers.c */

uint64_t powers_volume(uint16_t edge)
{
    const uint64_t result_value = (uint64_t)edge;
    return result_value * result_value * result_value;
}

bessemer_status_t powers_scale(uint32_t digits, uint32_t *result)
{
    bessemer_status_t status;
    status = integer_pow_u32(10U, digits, result);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    return BESSEMER_STATUS_OK;
}
