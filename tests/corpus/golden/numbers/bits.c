/* The C of tests/corpus/src/programs/numbers/bits.rs. Written by a test. */

/* bits.c */

static const uint8_t CHANNEL = 7U;
static const uint8_t READY = 128U;

uint8_t bits_with_channel(uint8_t register_, uint8_t channel)
{
    return (uint8_t)((register_ & (uint8_t)~(uint8_t)(CHANNEL | READY)) | (channel & CHANNEL));
}

bool bits_is_ahead(uint16_t one, uint16_t other)
{
    const uint16_t ahead = (uint16_t)((uint32_t)one - (uint32_t)other);
    return ahead > 0U && ahead < 0x8000U;
}

bool bits_parity(uint32_t word)
{
    return count_ones_u32(word) % 2U == 1U;
}

bessemer_status_t bits_highest(uint32_t word, uint32_t *result)
{
    if (word == 0U) {
        *result = 32U;
        return BESSEMER_STATUS_OK;
    } else {
        if (leading_zeros_u32(word) > 31U) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        *result = 31U - leading_zeros_u32(word);
        return BESSEMER_STATUS_OK;
    }
}
