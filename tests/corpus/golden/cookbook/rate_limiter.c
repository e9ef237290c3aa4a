/* The C of tests/corpus/src/programs/cookbook/rate_limiter.rs. Written by a test. */

/* rate_limiter.c */

void rate_limiter_init(rate_limiter_t *self)
{
    self->output = 0.0F;
}

float rate_limiter_step(rate_limiter_t *BESSEMER_RESTRICT self, const slew_limits_t *limits,
    float target)
{
    const float highest = self->output + limits->rise * limits->period;
    const float lowest = self->output - limits->fall * limits->period;
    if (target > highest) {
        self->output = highest;
    } else if (target < lowest) {
        self->output = lowest;
    } else if (isfinite(target) != 0) {
        self->output = target;
    } else {
        /* Nothing. */
    }
    return self->output;
}

void rate_limiter_preset(rate_limiter_t *self, float output)
{
    self->output = output;
}

/* rate_limiter.h */

/** Largest rates of a setpoint. */
typedef struct {
    /** Fastest rise, 0 or more. Unit: 1/s. */
    float rise;
    /** Fastest fall, 0 or more. Unit: 1/s. */
    float fall;
    /** Control period, above 0. Unit: s. */
    float period;
} slew_limits_t;

/** Follows a setpoint at limited rates. */
typedef struct {
    /** Last output. */
    float output;
} rate_limiter_t;
