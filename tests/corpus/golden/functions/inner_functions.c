/* The C of tests/corpus/src/programs/functions/inner_functions.rs. Written by a test. */

/* inner_functions.c */

static const pair_u8_u8_t EXTRAS[5] = {
    {.first = 0U, .second = 50U},
    {.first = 1U, .second = 124U},
    {.first = 24U, .second = 24U},
    {.first = 30U, .second = 39U},
    {.first = 33U, .second = 104U}
};

static void inner_functions_order_in_middle(float *BESSEMER_RESTRICT low,
    float *BESSEMER_RESTRICT high);
static void inner_functions_binary_search_by_key_in_extra(const pair_u8_u8_t values[],
    uint64_t values_length, uint8_t wanted, result_usize_usize_t *BESSEMER_RESTRICT result);

float inner_functions_middle(const float a_b_c_d_e[5])
{
    float a = a_b_c_d_e[0];
    float b = a_b_c_d_e[1];
    float c = a_b_c_d_e[2];
    float d = a_b_c_d_e[3];
    float e = a_b_c_d_e[4];
    inner_functions_order_in_middle(&a, &b);
    inner_functions_order_in_middle(&d, &e);
    inner_functions_order_in_middle(&c, &e);
    inner_functions_order_in_middle(&c, &d);
    inner_functions_order_in_middle(&a, &d);
    inner_functions_order_in_middle(&a, &c);
    inner_functions_order_in_middle(&b, &d);
    inner_functions_order_in_middle(&b, &c);
    return c;
}

/** Puts two samples in order. */
static void inner_functions_order_in_middle(float *BESSEMER_RESTRICT low,
    float *BESSEMER_RESTRICT high)
{
    if (*high < *low) {
        const float kept = *low;
        *low = *high;
        *high = kept;
    }
}

bessemer_status_t inner_functions_extra(uint8_t message, option_u8_t *result)
{
    result_usize_usize_t outcome;
    inner_functions_binary_search_by_key_in_extra(EXTRAS, UINT64_C(5), message, &outcome);
    option_usize_t result_choice = {.is_some = false};
    if (outcome.is_ok) {
        result_choice.is_some = true;
        result_choice.value = outcome.as.value;
    }
    if (result_choice.is_some) {
        if (result_choice.value >= UINT64_C(5)) {
            return BESSEMER_STATUS_INDEX;
        }
        result->is_some = true;
        result->value = EXTRAS[result_choice.value].second;
        return BESSEMER_STATUS_OK;
    } else {
        *result = (option_u8_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
}

/**
 * The index of an element whose key is `wanted`.
 *
 * # Errors
 *
 * The index at which such an element could be inserted, if there is none.
 */
static void inner_functions_binary_search_by_key_in_extra(const pair_u8_u8_t values[],
    uint64_t values_length, uint8_t wanted, result_usize_usize_t *BESSEMER_RESTRICT result)
{
    uint64_t from = UINT64_C(0);
    uint64_t left = values_length;
    for (int32_t pass = 0; pass < 64; pass++) {
        const uint64_t middle = from + left / UINT64_C(2);
        if (left == UINT64_C(0) || middle >= values_length) {
            break;
        }
        const pair_u8_u8_t value = values[middle];
        const uint8_t found = value.first;
        if (found == wanted) {
            result->is_ok = true;
            result->as.value = middle;
            return;
        }
        if (found < wanted) {
            from = middle + UINT64_C(1);
            left = left - left / UINT64_C(2) - UINT64_C(1);
        } else {
            left /= UINT64_C(2);
        }
    }
    result->is_ok = false;
    result->as.error = from;
}

/* mixing.c */

static double mixing_mix_in_step(double from, double to, double share);

void mixing_init(mixing_t *self)
{
    self->state = 0.0;
}

double mixing_step(mixing_t *self, double sample, bool fast)
{
    double share;
    if (fast) {
        share = 0.5;
    } else {
        share = 0.125;
    }
    self->state = mixing_mix_in_step(self->state, sample, share);
    return self->state;
}

static double mixing_mix_in_step(double from, double to, double share)
{
    return from + (to - from) * share;
}

/* mixing.h */

/** Smooths a signal. */
typedef struct {
    double state;
} mixing_t;
