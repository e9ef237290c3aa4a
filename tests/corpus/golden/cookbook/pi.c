/* The C of tests/corpus/src/programs/cookbook/pi.rs. Written by a test. */

/* pi.h */

/** Gains and limits of a speed loop. */
typedef struct {
    /** Proportional gain, 0 or more. Unit: V·s/rad. */
    float proportional;
    /** Integral gain, 0 or more. Unit: V/rad. */
    float integral;
    /** Control period, above 0. Unit: s. */
    float period;
    /** Lowest output. Unit: V. */
    float low;
    /** Highest output, not below the lowest. Unit: V. */
    float high;
} pi_parameters_t;

/* pi_controller.c */

void pi_controller_init(pi_controller_t *self)
{
    self->integral = 0.0F;
}

float pi_controller_step(pi_controller_t *BESSEMER_RESTRICT self, const pi_parameters_t *parameters,
    float target, float measured)
{
    const float error = target - measured;
    const float integral = self->integral + parameters->integral * parameters->period * error;
    const float wanted = parameters->proportional * error + integral;
    const float output = min_f32(max_f32(wanted, parameters->low), parameters->high);

    /* Positive above the upper limit, negative below the lower one. */
    const float beyond = wanted - output;
    if (beyond * error <= 0.0F) {
        self->integral = integral;
    }
    return output;
}

void pi_controller_preset(pi_controller_t *BESSEMER_RESTRICT self,
    const pi_parameters_t *parameters, float output)
{
    self->integral = min_f32(max_f32(output, parameters->low), parameters->high);
}

/* pi_controller.h */

/** Controls a speed. */
typedef struct {
    /** Integral part of the output. Unit: V. */
    float integral;
} pi_controller_t;
