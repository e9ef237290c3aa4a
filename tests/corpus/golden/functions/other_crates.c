/* The C of tests/corpus/src/programs/functions/other_crates.rs. Written by a test. */

/* gain.c */

void other_crates_gain_init(other_crates_gain_t *self)
{
    self->factor = 0.0;
}

double other_crates_gain_step(other_crates_gain_t *self, double input)
{
    return self->factor * input + FILTERS_CURVE[2];
}

/* gain.h */

/** A component that implements the other crate's trait. */
typedef struct {
    double factor;
} other_crates_gain_t;

/* reading.c */

static const double LIMIT = 50.0;

void other_crates_reading_init(other_crates_reading_t *self)
{
    filters_low_pass_init(&self->low);
    delay_f64_3_init(&self->delay);
    self->health.tag = HEALTH_TAG_GOOD;
    self->health.stale = 0U;
    self->height.value = 0.0;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t other_crates_reading_step(other_crates_reading_t *BESSEMER_RESTRICT self,
    double input, bool valid, double *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if (valid) {
        self->health = (filters_health_t){.tag = HEALTH_TAG_GOOD};
    } else if (self->health.tag == HEALTH_TAG_GOOD) {
        self->health.tag = HEALTH_TAG_STALE;
        self->health.stale = 1U;
    } else {
        const uint8_t steps = self->health.stale;
        self->health.tag = HEALTH_TAG_STALE;
        self->health.stale = saturating_add_u8(steps, 1U);
    }
    const double smooth = filters_low_pass_step(&self->low, filters_interpolate(input));
    const quantities_metres_t height_other = {.value = 1.0};
    quantities_metres_t height_next;
    quantities_metres_add(&self->height, &height_other, &height_next);
    self->height = height_next;
    double result_a;
    status = delay_f64_3_push(&self->delay, smooth, &result_a);
    if (status != BESSEMER_STATUS_OK) {
        self->fault = status;
        return status;
    }
    *result = filters_larger_f64(result_a, quantities_metres_number(&self->height) * LIMIT);
    return BESSEMER_STATUS_OK;
}

/* reading.h */

/** A reading to be filtered. */
typedef struct {
    filters_low_pass_t low;
    delay_f64_3_t delay;
    filters_health_t health;
    quantities_metres_t height;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} other_crates_reading_t;

/* smooth_gain.c */

void smooth_gain_init(smooth_gain_t *self)
{
    filters_low_pass_init(&self->first);
    other_crates_gain_init(&self->second);
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t smooth_gain_step(smooth_gain_t *BESSEMER_RESTRICT self, double input,
    double *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    const double between = filters_low_pass_step(&self->first, input);
    *result = other_crates_gain_step(&self->second, between);
    return BESSEMER_STATUS_OK;
}

/* smooth_gain.h */

/** A filter of the other crate, followed by the one above. */
typedef struct {
    filters_low_pass_t first;
    other_crates_gain_t second;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} smooth_gain_t;
