/* The C of tests/corpus/src/programs/numbers/bits.rs. Written by a test. */

/* bits.c */

static const uint8_t CHANNEL = 7U;
static const uint8_t READY = 128U;

/* How many bits are set: counted in pairs, in fours, in bytes, and these added up. */
static uint32_t count_ones_u32(uint32_t bits)
{
    const uint32_t ones = bits - ((bits >> 1U) & 0x55555555U);
    const uint32_t twos = (ones & 0x33333333U) + ((ones >> 2U) & 0x33333333U);
    const uint32_t fours = (twos + (twos >> 4U)) & 0x0F0F0F0FU;
    return (fours * 0x01010101U) >> 24U;
}

/* How many bits stand above the highest that is set; all, if none is. */
static uint32_t leading_zeros_u32(uint32_t bits)
{
    uint32_t filled = bits;
    filled |= filled >> 1U;
    filled |= filled >> 2U;
    filled |= filled >> 4U;
    filled |= filled >> 8U;
    filled |= filled >> 16U;
    return count_ones_u32(~filled);
}

uint8_t bits_with_channel(uint8_t register_, uint8_t channel)
{
    return (uint8_t)((uint8_t)(register_ & (uint8_t)~(uint8_t)(CHANNEL | READY))
        | (uint8_t)(channel & CHANNEL));
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
