/* The C of tests/corpus/src/programs/functions/generic_components.rs. Written by a test. */

/* delay_f64_4.c */

void delay_f64_4_init(delay_f64_4_t *self)
{
    self->line[0] = 0.0;
    self->line[1] = 0.0;
    self->line[2] = 0.0;
    self->line[3] = 0.0;
    self->oldest = UINT64_C(0);
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t delay_f64_4_push(delay_f64_4_t *BESSEMER_RESTRICT self, double value,
    double *BESSEMER_RESTRICT old)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if (self->oldest >= UINT64_C(4)) {
        self->fault = BESSEMER_STATUS_INDEX;
        return BESSEMER_STATUS_INDEX;
    }
    const double old_value = self->line[self->oldest];
    self->line[self->oldest] = value;
    self->oldest = (self->oldest + UINT64_C(1)) % UINT64_C(4);
    *old = old_value;
    return BESSEMER_STATUS_OK;
}

/* delay_f64_4.h */

/** The last `N` values, oldest first. */
typedef struct {
    double line[4];
    uint64_t oldest;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} delay_f64_4_t;

/* delayed.c */

void delayed_init(delayed_t *self)
{
    pi_f64_init(&self->pi);
    delay_f64_4_init(&self->dead_time);
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t delayed_step(delayed_t *BESSEMER_RESTRICT self, double error,
    double *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    double late;
    status = delay_f64_4_push(&self->dead_time, error, &late);
    if (status != BESSEMER_STATUS_OK) {
        self->fault = status;
        return status;
    }
    *result = pi_f64_step(&self->pi, late, 0.01);
    return BESSEMER_STATUS_OK;
}

/* delayed.h */

/** A loop with a dead time of four periods. */
typedef struct {
    pi_f64_t pi;
    delay_f64_4_t dead_time;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} delayed_t;

/* fast_pi.c */

static const float FAST_PI_GAIN_F32 = 0.1F;

void fast_pi_init(fast_pi_t *self)
{
    self->integral = 0.0F;
}

float fast_pi_step(fast_pi_t *self, float error, float period)
{
    self->integral = clamp_f32(self->integral + error * period, -1.0F, 1.0F);
    return error + self->integral * FAST_PI_GAIN_F32;
}

/* fast_pi.h */

/** The controller of the fast loop, in single precision. */
typedef struct {
    /** The integral of the error. */
    float integral;
} fast_pi_t;

/* pi_f64.c */

static const double PI_F64_GAIN = 0.1;

void pi_f64_init(pi_f64_t *self)
{
    self->integral = 0.0;
}

double pi_f64_step(pi_f64_t *self, double error, double period)
{
    self->integral = clamp_f64(self->integral + error * period, -1.0, 1.0);
    return error + self->integral * PI_F64_GAIN;
}

/* pi_f64.h */

/** A PI controller. */
typedef struct {
    /** The integral of the error. */
    double integral;
} pi_f64_t;
