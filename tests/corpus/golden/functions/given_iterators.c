/* The C of tests/corpus/src/programs/functions/given_iterators.rs. Written by a test. */

/* given_iterators.c */

static const uint32_t U16_BITS = 16U;

bool inputs_contains(const inputs_t *self, uint16_t n)
{
    return n < 16U && ((self->bits >> n) & 1U) == 1U;
}

void readings_summary(const readings_t *self,
    tuple4_usize_f64_option_f64_option_f64_t *BESSEMER_RESTRICT result)
{
    double steps = 0.0;
    for (uint32_t i = 0U; i < 5U; i++) {
        steps = max_f64(steps, fabs(self->values[i + 1U] - self->values[i]));
    }
    uint32_t rising = 0U;
    for (uint32_t i = 0U; i < 5U; i++) {
        if (self->values[i] < self->values[i + 1U]) {
            rising += 1U;
        }
    }
    double area = -0.0;
    for (uint32_t i = 0U; i < 6U; i++) {
        area += self->values[i] * self->values[(i + 1U) % 6U];
    }
    uint32_t most;
    if (self->valid > UINT64_C(6)) {
        most = 0U;
    } else {
        most = (uint32_t)self->valid;
    }
    result->third = (option_f64_t){.is_some = false};
    for (uint32_t i = 0U; i < most; i++) {
        if (self->values[i] < self->most) {
            const double item = self->values[i] * 2.0;
            result->third.is_some = true;
            result->third.value = item;
        }
    }
    uint32_t most_2;
    if (self->valid > UINT64_C(6)) {
        most_2 = 0U;
    } else {
        most_2 = (uint32_t)self->valid;
    }
    result->fourth = (option_f64_t){.is_some = false};
    for (uint32_t i = 0U; i < most_2; i++) {
        if (self->values[i] < self->most) {
            const double item = self->values[i] * 0.5;
            result->fourth.is_some = true;
            result->fourth.value = item;
            break;
        }
    }
    result->first = rising;
    result->second = steps + area;
}

void readings_largest(const readings_t *self, option_f64_t *BESSEMER_RESTRICT result)
{
    uint32_t most;
    if (self->valid > UINT64_C(6)) {
        most = 0U;
    } else {
        most = (uint32_t)self->valid;
    }
    *result = (option_f64_t){.is_some = false};
    for (uint32_t i = 0U; i < most; i++) {
        if (self->values[i] < self->most) {
            if (result->is_some) {
                const double one = result->value;
                if (!sort_below_f64(self->values[i], one)) {
                    result->is_some = true;
                    result->value = self->values[i];
                }
            } else {
                result->is_some = true;
                result->value = self->values[i];
            }
        }
    }
}

void readings_before(const readings_t *self, double limit, option_usize_t *BESSEMER_RESTRICT result)
{
    uint32_t next = 0U;
    uint32_t most;
    if (self->valid > UINT64_C(6)) {
        most = 0U;
    } else {
        most = (uint32_t)self->valid;
    }
    for (uint32_t i = 0U; i < most; i++) {
        if (self->values[i] < self->most) {
            const uint32_t at = next;
            next += 1U;
            if (self->values[i] * 1.5 > limit) {
                result->is_some = true;
                result->value = at;
                return;
            }
        }
    }
    *result = (option_usize_t){.is_some = false};
}

bessemer_status_t given_iterators_weighed(const inputs_t *inputs, const inputs_t *more,
    uint32_t *BESSEMER_RESTRICT result)
{
    uint32_t sum = 0U;
    for (uint16_t n = 0U; n < (uint16_t)U16_BITS; n++) {
        if (inputs_contains(inputs, n)) {
            if (n == 3U) {
                continue;
            }
            if (n == 12U) {
                break;
            }
            sum += (uint32_t)n;
        }
    }
    for (uint16_t one = 0U; one < (uint16_t)U16_BITS; one++) {
        if (inputs_contains(inputs, one)) {
            bool outer_next = false;
            bool outer_done = false;
            for (uint16_t other = 0U; other < (uint16_t)U16_BITS; other++) {
                if (inputs_contains(more, other)) {
                    if (other > one) {
                        outer_next = true;
                        break;
                    }
                    if (other == 11U) {
                        outer_done = true;
                        break;
                    }
                    if ((int64_t)sum + (int64_t)(uint16_t)(one - other) > (int64_t)UINT32_MAX) {
                        return BESSEMER_STATUS_OVERFLOW;
                    }
                    sum += (uint32_t)(uint16_t)(one - other);
                }
            }
            if (outer_next) {
                continue;
            }
            if (outer_done) {
                break;
            }
        }
    }
    uint32_t count = 0U;
    for (uint16_t n = 0U; n < (uint16_t)U16_BITS; n++) {
        if (inputs_contains(more, n)) {
            count += 1U;
        }
    }
    if ((int64_t)sum + (int64_t)count > (int64_t)UINT32_MAX) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    const uint32_t result_left = sum + count;
    uint16_t sum_2 = 0U;
    for (uint16_t n = 0U; n < (uint16_t)U16_BITS; n++) {
        if (inputs_contains(inputs, n)) {
            if ((int64_t)sum_2 + (int64_t)n > INT64_C(65535)) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            sum_2 = (uint16_t)(sum_2 + n);
        }
    }
    if ((int64_t)result_left + (int64_t)sum_2 > (int64_t)UINT32_MAX) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    *result = result_left + (uint32_t)sum_2;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t given_iterators_first_share(uint32_t of, const uint32_t by[3],
    uint32_t *BESSEMER_RESTRICT most)
{
    uint32_t most_value = 0U;
    for (uint32_t i = 0U; i < 3U; i++) {
        const uint32_t part = by[i];
        if (part == 0U) {
            return BESSEMER_STATUS_DIVISION_BY_ZERO;
        }
        const uint32_t share = of / part;
        if (share > 100U) {
            *most = share;
            return BESSEMER_STATUS_OK;
        }
        most_value = max_u32(share, most_value);
    }
    *most = most_value;
    return BESSEMER_STATUS_OK;
}

bool given_iterators_fences(double low, double high, double value)
{
    const double reach = 1.5 * (high - low);
    closed_f64_t result_range;
    given_iterators_around(low, high, reach, &result_range);
    return range_closed_contains_f64(&result_range, value);
}

void given_iterators_around(double low, double high, double reach, closed_f64_t *closed)
{
    closed->start = low - reach;
    closed->end = high + reach;
}

/* given_iterators.h */

/** A set of inputs, one bit for each. */
typedef struct {
    uint16_t bits;
} inputs_t;

/** Readings of a sensor, of which the first `count` are valid. */
typedef struct {
    double values[6];
    uint64_t valid;
    double most;
} readings_t;
