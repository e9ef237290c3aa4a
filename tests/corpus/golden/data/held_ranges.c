/* The C of tests/corpus/src/programs/data/held_ranges.rs. Written by a test. */

/* held_ranges.c */

int32_t held_ranges_middle(const closed_i32_t *range)
{
    return whole_midpoint_i32(range->start, range->end);
}

/* held_ranges_gauge.c */

void held_ranges_gauge_init(held_ranges_gauge_t *self)
{
    /* In Rust: `PLAUSIBLE`. */
    self->limits.start = -40.0F;
    self->limits.end = 125.0F;
    self->samples.start = 2U;
    self->samples.end = 14U;
    self->last = 0.0F;
}

void held_ranges_gauge_step(held_ranges_gauge_t *BESSEMER_RESTRICT self, uint16_t number,
    float value, option_f32_t *BESSEMER_RESTRICT result)
{
    if (!range_contains_u16(&self->samples, number)
            || !range_closed_contains_f32(&self->limits, value)) {
        *result = (option_f32_t){.is_some = false};
        return;
    }
    self->last = value;
    result->is_some = true;
    result->value = (value - self->limits.start) / (self->limits.end - self->limits.start);
}

bool held_ranges_gauge_limit(held_ranges_gauge_t *BESSEMER_RESTRICT self, float low, float high,
    const half_open_u16_t *samples)
{
    const closed_f32_t limits = {.start = low, .end = high};
    if (range_closed_is_empty_f32(&limits) || range_is_empty_u16(samples) || samples->end > 16U) {
        return false;
    }
    self->limits = limits;
    self->samples = *samples;
    return true;
}

/* held_ranges_gauge.h */

/** A channel with limits. */
typedef struct {
    /** Accepted range. */
    closed_f32_t limits;
    /** Numbers of the samples of a period that count. */
    half_open_u16_t samples;
    /** The last accepted value. */
    float last;
} held_ranges_gauge_t;
