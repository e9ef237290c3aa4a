/* The C of tests/corpus/src/programs/blocks/limiting.rs. Written by a test. */

/* gimbal.c */

void gimbal_init(gimbal_t *self)
{
    jerk_limiter_f64_init(&self->limiter);
    hysteresis_init(&self->away);
}

void gimbal_step(gimbal_t *BESSEMER_RESTRICT self, const jerk_limits_f64_t *limits, double target,
    bool lost, motion_f64_t *BESSEMER_RESTRICT motion)
{
    if (lost) {
        jerk_limiter_f64_preset(&self->limiter, 0.0);
    }
    double target_2;
    if (hysteresis_step_f64(&self->away, 3.0, 2.5, target)) {
        target_2 = 3.0;
    } else {
        target_2 = target;
    }
    jerk_limiter_f64_step(&self->limiter, limits, target_2, motion);
}

/* gimbal.h */

/** Moves a camera's gimbal smoothly. */
typedef struct {
    jerk_limiter_f64_t limiter;
    hysteresis_t away;
} gimbal_t;

/* valve.c */

void limiting_valve_init(limiting_valve_t *self)
{
    rate_limiter_f32_init(&self->rate);
    hysteresis_init(&self->closing);
}

void limiting_valve_step(limiting_valve_t *BESSEMER_RESTRICT self, const rate_limits_f32_t *limits,
    float stick, float pressure, saturated_f32_t *BESSEMER_RESTRICT saturated)
{
    const float wanted = bessemer_blocks_limits_dead_band_f32(stick, 0.05F);
    float wanted_2;
    if (hysteresis_step_f32(&self->closing, 8.0F, 6.0F, pressure)) {
        wanted_2 = 0.0F;
    } else {
        wanted_2 = wanted;
    }
    const float saturated_value = rate_limiter_f32_step(&self->rate, limits, wanted_2);
    bessemer_blocks_limits_saturated_f32(saturated_value, 0.0F, 1.0F, saturated);
}

void limiting_valve_preset(limiting_valve_t *self, float position)
{
    rate_limiter_f32_preset(&self->rate, position);
}

/* valve.h */

/** Moves a valve. */
typedef struct {
    rate_limiter_f32_t rate;
    hysteresis_t closing;
} limiting_valve_t;
