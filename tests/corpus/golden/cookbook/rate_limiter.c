/* The C of tests/corpus/src/programs/cookbook/rate_limiter.rs. Written by a test. */

/* setpoint.c */

void setpoint_init(setpoint_t *self)
{
    rate_limiter_f32_init(&self->limiter);
    self->is_closed = false;
}

float setpoint_step(setpoint_t *BESSEMER_RESTRICT self, const rate_limits_f32_t *limits,
    bool closed, float target, float measured)
{
    const bool began = closed && !self->is_closed;
    self->is_closed = closed;
    if (began) {
        rate_limiter_f32_preset(&self->limiter, measured);
    }
    if (closed) {
        return rate_limiter_f32_step(&self->limiter, limits, target);
    } else {
        return measured;
    }
}

/* setpoint.h */

/** Moves a setpoint to its target. */
typedef struct {
    rate_limiter_f32_t limiter;
    /** True after the first period in which the loop is closed. */
    bool is_closed;
} setpoint_t;
