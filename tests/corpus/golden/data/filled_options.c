/* The C of tests/corpus/src/programs/data/filled_options.rs. Written by a test. */

/* filled_options.c */

static const option_u32_t OPTION_U32_DEFAULT = {.is_some = false, .value = 0U};

double smooth_update(smooth_t *self, double input)
{
    if (!self->state.is_some) {
        self->state.is_some = true;
        self->state.value = input;
    }
    self->state.value += 0.25 * (input - self->state.value);
    return self->state.value;
}

double smooth_restart(smooth_t *self, double input)
{
    self->state.is_some = true;
    self->state.value = input;
    return self->state.value + 1.0;
}

bessemer_status_t filled_options_count(option_u8_t *BESSEMER_RESTRICT counter,
    bool *BESSEMER_RESTRICT result)
{
    if (counter->is_some) {
        if (counter->value > 254U) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        counter->value = (uint8_t)(counter->value + 1U);
        *result = true;
        return BESSEMER_STATUS_OK;
    }
    *result = false;
    return BESSEMER_STATUS_OK;
}

uint32_t filled_options_pulse(option_u32_t *start, uint32_t now, bool high)
{
    if (!high) {
        const option_u32_t kept = *start;
        *start = OPTION_U32_DEFAULT;
        const option_u32_t result_choice = kept;
        if (result_choice.is_some) {
            const uint32_t start_2 = result_choice.value;
            return now - start_2;
        } else {
            return 0U;
        }
    }
    if (!start->is_some) {
        start->is_some = true;
        start->value = now;
    }
    return now - start->value;
}

void filled_options_only(const option_f32_t *left, const option_f32_t *right,
    option_f32_t *BESSEMER_RESTRICT result)
{
    if (left->is_some && !right->is_some) {
        result->is_some = true;
        result->value = left->value;
    } else if (!left->is_some && right->is_some) {
        result->is_some = true;
        result->value = right->value;
    } else {
        *result = (option_f32_t){.is_some = false};
    }
}

/* filled_options.h */

/** A filter that starts at its first input. */
typedef struct {
    /** Present value. */
    option_f64_t state;
} smooth_t;
