/* The C of tests/corpus/src/programs/control/own_iterators.rs. Written by a test. */

/* programs_control_own_iterators.c */

static const uint64_t LIMIT = UINT64_C(12);

void programs_control_own_iterators_ramp_new(int32_t from, int32_t to, int32_t slope,
    programs_control_own_iterators_ramp_t *ramp)
{
    int32_t result_choice;
    if (slope < 0) {
        result_choice = saturating_sub_i32(0, slope);
    } else {
        result_choice = slope;
    }
    ramp->at = from;
    ramp->goal = to;
    ramp->slope = max_i32(result_choice, 1);
}

bessemer_status_t programs_control_own_iterators_ramp_next(
    programs_control_own_iterators_ramp_t *BESSEMER_RESTRICT self,
    option_i32_t *BESSEMER_RESTRICT result)
{
    if (self->at == self->goal) {
        *result = (option_i32_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    const int32_t left = saturating_sub_i32(self->goal, self->at);
    int32_t at_choice;
    if (left < 0) {
        at_choice = saturating_sub_i32(0, left);
    } else {
        at_choice = left;
    }
    if (at_choice <= self->slope) {
        self->at = self->goal;
    } else {
        int32_t at_choice_2;
        if (left < 0) {
            if (self->slope == INT32_MIN) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            at_choice_2 = -self->slope;
        } else {
            at_choice_2 = self->slope;
        }
        self->at = saturating_add_i32(self->at, at_choice_2);
    }
    result->is_some = true;
    result->value = self->at;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t programs_control_own_iterators_through(int32_t from, int32_t to,
    pair_u32_i32_t *result)
{
    bessemer_status_t status;
    uint32_t steps = 0U;
    int32_t sum = 0;
    programs_control_own_iterators_ramp_t ramp;
    programs_control_own_iterators_ramp_new(from, to, 1000, &ramp);
    for (uint32_t pass = 0U; pass <= LIMIT; pass++) {
        option_i32_t value;
        status = programs_control_own_iterators_ramp_next(&ramp, &value);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (!value.is_some) {
            break;
        }
        if (pass >= LIMIT) {
            return BESSEMER_STATUS_BOUND;
        }
        steps += 1U;
        sum = wrap_i32((uint32_t)sum + (uint32_t)value.value);
    }
    result->first = steps;
    result->second = sum;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t programs_control_own_iterators_taken(int32_t from, int32_t to, uint64_t n,
    int32_t *result)
{
    bessemer_status_t status;
    programs_control_own_iterators_ramp_t ramp;
    programs_control_own_iterators_ramp_new(from, to, 10, &ramp);
    const uint64_t n_2 = n & UINT64_C(7);
    int32_t sum = 0;
    for (uint64_t pass = UINT64_C(0); pass < n_2; pass++) {
        option_i32_t item;
        status = programs_control_own_iterators_ramp_next(&ramp, &item);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (!item.is_some) {
            break;
        }
        const int32_t x = wrap_i32((uint32_t)item.value * 3U);
        if (x % 2 == 0) {
            sum ^= x;
        }
    }
    *result = sum;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t programs_control_own_iterators_followed(const int32_t values[5], int32_t to,
    int32_t *BESSEMER_RESTRICT sum)
{
    bessemer_status_t status;
    int32_t sum_value = 0;
    programs_control_own_iterators_ramp_t ramp;
    programs_control_own_iterators_ramp_new(0, to, 3, &ramp);
    for (uint32_t i = 0U; i < 5U; i++) {
        option_i32_t step;
        status = programs_control_own_iterators_ramp_next(&ramp, &step);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (!step.is_some) {
            break;
        }
        sum_value = wrap_i32((uint32_t)sum_value + (uint32_t)values[i] * (uint32_t)step.value);
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

/* programs_control_own_iterators.h */

/** The steps of a ramp: each changes by at most the slope, and the last is the goal. */
typedef struct {
    int32_t at;
    int32_t goal;
    int32_t slope;
} programs_control_own_iterators_ramp_t;
