/* The C of tests/corpus/src/programs/functions/controller_slot.rs. Written by a test. */

/* controller_slot.c */

static const double GAIN_LIMIT = 1.0;

void controller_slot_gain_reset(controller_slot_gain_t *self)
{
    (void)self;
}

double controller_slot_gain_limited(controller_slot_gain_t *self, double error)
{
    const double result_step = controller_slot_gain_step(self, error);
    return clamp_f64(result_step, -GAIN_LIMIT, GAIN_LIMIT);
}

double controller_slot_gain_step(controller_slot_gain_t *self, double error)
{
    return self->gain * error;
}

/* controller_slot.h */

/** A proportional controller. */
typedef struct {
    /** Factor of the error. */
    double gain;
} controller_slot_gain_t;

/* gain_loop.c */

void gain_loop_init(gain_loop_t *self)
{
    self->controller.gain = 0.0;
}

double gain_loop_step(gain_loop_t *self, double target, double measured, bool reset)
{
    if (reset) {
        controller_slot_gain_reset(&self->controller);
    }
    return controller_slot_gain_limited(&self->controller, target - measured);
}

/* gain_loop.h */

/** A loop with a proportional controller. */
typedef struct {
    /** The controller. */
    controller_slot_gain_t controller;
} gain_loop_t;

/* integrator.c */

static const double INTEGRATOR_LIMIT = 0.5;

static double integrator_step(integrator_t *self, double error);

double integrator_limited(integrator_t *self, double error)
{
    const double result_step = integrator_step(self, error);
    return clamp_f64(result_step, -INTEGRATOR_LIMIT, INTEGRATOR_LIMIT);
}

void integrator_init(integrator_t *self)
{
    self->sum = 0.0;
}

static double integrator_step(integrator_t *self, double error)
{
    self->sum += 0.01 * error;
    return self->sum;
}

void integrator_reset(integrator_t *self)
{
    self->sum = 0.0;
}

/* integrator.h */

/** An integrating controller. */
typedef struct {
    double sum;
} integrator_t;

/* integrator_loop.c */

void integrator_loop_init(integrator_loop_t *self)
{
    integrator_init(&self->controller);
}

double integrator_loop_step(integrator_loop_t *self, double target, double measured, bool reset)
{
    if (reset) {
        integrator_reset(&self->controller);
    }
    return integrator_limited(&self->controller, target - measured);
}

/* integrator_loop.h */

/** A loop with an integrating controller. */
typedef struct {
    /** The controller. */
    integrator_t controller;
} integrator_loop_t;
