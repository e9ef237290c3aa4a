/* The C of tests/corpus/src/programs/blocks/attitudes.rs. Written by a test. */

/* attitudes.h */

/** Working memory of its entry point; the contents are undefined between calls. */
typedef struct {
    error_state_filter_f64_step_work_t error_state_filter_f64_step;
} compassed_step_work_t;

/* compassed.c */

void compassed_init(compassed_t *self)
{
    error_state_filter_f64_init(&self->filter);
}

void compassed_step(compassed_t *BESSEMER_RESTRICT self, const error_state_noise_f64_t *noise,
    const double rates[3], const double force[3], compassed_step_work_t *BESSEMER_RESTRICT work,
    unit_quaternion_f64_t *BESSEMER_RESTRICT unit_quaternion)
{
    error_state_filter_f64_step(&self->filter, noise, rates, force,
        &work->error_state_filter_f64_step, unit_quaternion);
}

void compassed_heed(compassed_t *BESSEMER_RESTRICT self, const double north[3],
    const double field[3], double result[BESSEMER_RESTRICT 3])
{
    {
        correction_f64_t unused;
        error_state_filter_f64_correct(&self->filter, north, field, 0.01, 16.0, &unused);
    }
    error_state_filter_f64_bias(&self->filter, result);
}

/* compassed.h */

/** Estimates an attitude and the bias of its gyroscope, also with a compass. */
typedef struct {
    error_state_filter_f64_t filter;
} compassed_t;

/* estimators.c */

void estimators_init(estimators_t *self)
{
    mahony_f64_init(&self->mahony);
    madgwick_f64_init(&self->madgwick);
}

void estimators_step(estimators_t *BESSEMER_RESTRICT self, const mahony_gains_f64_t *mahony,
    const madgwick_gain_f64_t *madgwick, const double rates[3], const double force[3],
    double result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f64_t one;
    mahony_f64_step(&self->mahony, mahony, rates, force, &one);
    unit_quaternion_f64_t other;
    madgwick_f64_step(&self->madgwick, madgwick, rates, force, &other);
    double result_attitude_error_f64[3];
    attitude_attitude_error_f64(&one, &other, result_attitude_error_f64);
    double result_up[3];
    madgwick_f64_up(&self->madgwick, result_up);
    result[0] = result_attitude_error_f64[0] + result_up[0];
    result[1] = result_attitude_error_f64[1] + result_up[1];
    result[2] = result_attitude_error_f64[2] + result_up[2];
}

/* estimators.h */

/** Estimates an attitude by both filters. */
typedef struct {
    mahony_f64_t mahony;
    madgwick_f64_t madgwick;
} estimators_t;

/* levelled.c */

void levelled_init(levelled_t *self)
{
    mahony_f32_init(&self->filter);
}

void levelled_step(levelled_t *BESSEMER_RESTRICT self, const mahony_gains_f32_t *gains,
    const attitude_gains_f32_t *control, const float rates[3], const float force[3],
    float result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f32_t attitude;
    mahony_f32_step(&self->filter, gains, rates, force, &attitude);
    const unit_quaternion_f32_t level = {.i = 0.0F, .j = 0.0F, .k = 0.0F, .w = 1.0F};
    const float result_target_rates[3] = {0.0F, 0.0F, 0.0F};
    attitude_attitude_torque_f32(control, &attitude, rates, &level, result_target_rates, result);
}

void levelled_up(const levelled_t *self, float result[BESSEMER_RESTRICT 3])
{
    mahony_f32_up(&self->filter, result);
}

/* levelled.h */

/** Estimates an attitude and controls it. */
typedef struct {
    mahony_f32_t filter;
} levelled_t;
