/* The C of tests/corpus/src/programs/control/labelled_blocks.rs. Written by a test. */

/* labelled_blocks.c */

uint64_t labelled_blocks_first_above(const double readings[6], double limit)
{
    uint32_t at = 0U;
    bool found_done = false;
    for (uint32_t i = 0U; i < 6U; i++) {
        if (readings[i] > limit) {
            at = i;
            found_done = true;
            break;
        }
    }
    if (!found_done) {
        at = 6U;
    }
    return at;
}

uint8_t labelled_blocks_level(float temperature, float rise)
{
    if (temperature > 90.0F) {
        return 3U;
    }
    const float soon = temperature + 10.0F * rise;
    if (soon > 90.0F) {
        return 2U;
    }
    if (soon > 70.0F) {
        return 1U;
    } else {
        return 0U;
    }
}

bessemer_status_t labelled_blocks_arm(bool ready, float voltage, bool *BESSEMER_RESTRICT armed,
    uint8_t *BESSEMER_RESTRICT refusals)
{
    if (!ready) {
        if (*refusals > 254U) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        *refusals = (uint8_t)(*refusals + 1U);
    } else if (!(voltage < 14.0F)) {
        *armed = true;
    } else {
        /* Nothing. */
    }
    return BESSEMER_STATUS_OK;
}
