/* The C of tests/corpus/src/programs/numbers/not_zero.rs. Written by a test. */

/* not_zero.c */

static const non_zero_u32_t NON_ZERO_U32_MIN = {.value = 1U};

bessemer_status_t not_zero_share(uint32_t counts, uint32_t of, option_u32_t *result)
{
    option_non_zero_u32_t of_option;
    non_zero_new_u32(of, &of_option);
    if (!of_option.is_some) {
        *result = (option_u32_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    const non_zero_u32_t of_2 = of_option.value;
    if (counts > 0x28F5C28U) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (of_2.value == 0U) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    result->is_some = true;
    result->value = counts * 100U / of_2.value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t periods_both(const periods_t *self, uint32_t *BESSEMER_RESTRICT result)
{
    uint32_t low = (uint32_t)self->ticks[0].value;
    uint32_t high = (uint32_t)self->ticks[1].value;
    const uint32_t product = low * high;
    for (int32_t pass = 0; pass < 32; pass++) {
        if (low == 0U) {
            break;
        }
        const uint32_t low_next = high % low;
        const uint32_t high_next = low;
        low = low_next;
        high = high_next;
    }
    if (high == 0U) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    *result = product / high;
    return BESSEMER_STATUS_OK;
}

bool periods_later(periods_t *self, int16_t by)
{
    int16_t delay;
    if (self->delay.is_some) {
        const non_zero_i16_t delay_2 = self->delay.value;
        delay = wrap_i16((uint16_t)((uint32_t)delay_2.value + (uint32_t)by));
    } else {
        delay = by;
    }
    non_zero_new_i16(delay, &self->delay);
    return self->delay.is_some;
}

bool not_zero_same(const non_zero_u32_t *one, const non_zero_u32_t *other)
{
    const bool result = one->value == other->value && one->value != NON_ZERO_U32_MIN.value;
    return result;
}

/* not_zero.h */

/** The periods of two tasks. */
typedef struct {
    /** The periods, in ticks. */
    non_zero_u16_t ticks[2];
    /** The delay in ticks; `None` without a delay. */
    option_non_zero_i16_t delay;
} periods_t;
