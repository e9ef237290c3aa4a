/* The C of tests/corpus/src/programs/blocks/attitudes.rs. Written by a test. */

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
