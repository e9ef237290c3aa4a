/* The C of blocks/src/pid.rs. Written by a test. */

/* pid.h */

/**
 * Gains and limits of a `Pid`. Units are those of the output (U), the measurement (Y) and seconds.
 *
 * `Default` has no gains, no limits, `target_weight` 1 and a period of 1 s.
 */
typedef struct {
    /** Proportional gain Kp, U/Y. */
    float proportional;
    /** Integral gain Ki, U/(Y·s). */
    float integral;
    /** Derivative gain Kd, U·s/Y. */
    float derivative;
    /** Weight b of the target in the proportional part, 0 to 1. */
    float target_weight;
    /**
     * Weight c of the target in the derivative part, 0 to 1; 0 avoids a kick when the target jumps.
     */
    float target_slope_weight;
    /** Time constant Tf of the derivative's filter, 0 or more. Unit: s. */
    float filter;
    /**
     * Rate Kt at which the integral follows a limited output, 0 to 1/period; with 0 it keeps its value at a limit.
     * Unit: 1/s.
     */
    float tracking;
    /** Lowest output, U. */
    float low;
    /** Highest output, not below the lowest, U. */
    float high;
    /** Control period h, above 0. Unit: s. */
    float period;
} pid_parameters_f32_t;

/**
 * Gains and limits of a `Pid`. Units are those of the output (U), the measurement (Y) and seconds.
 *
 * `Default` has no gains, no limits, `target_weight` 1 and a period of 1 s.
 */
typedef struct {
    /** Proportional gain Kp, U/Y. */
    double proportional;
    /** Integral gain Ki, U/(Y·s). */
    double integral;
    /** Derivative gain Kd, U·s/Y. */
    double derivative;
    /** Weight b of the target in the proportional part, 0 to 1. */
    double target_weight;
    /**
     * Weight c of the target in the derivative part, 0 to 1; 0 avoids a kick when the target jumps.
     */
    double target_slope_weight;
    /** Time constant Tf of the derivative's filter, 0 or more. Unit: s. */
    double filter;
    /**
     * Rate Kt at which the integral follows a limited output, 0 to 1/period; with 0 it keeps its value at a limit.
     * Unit: 1/s.
     */
    double tracking;
    /** Lowest output, U. */
    double low;
    /** Highest output, not below the lowest, U. */
    double high;
    /** Control period h, above 0. Unit: s. */
    double period;
} pid_parameters_f64_t;

/* pid_f32.c */

void pid_pid_f32_init(pid_pid_f32_t *self)
{
    self->integral = 0.0F;
    self->derivative = 0.0F;
    self->before = 0.0F;
    self->running = false;
}

float pid_pid_f32_step(pid_pid_f32_t *BESSEMER_RESTRICT self,
    const pid_parameters_f32_t *parameters, float target, float measured)
{
    const float error = target - measured;
    const float weighted = parameters->target_slope_weight * target - measured;
    float change;
    if (self->running) {
        change = weighted - self->before;
    } else {
        change = 0.0F;
    }
    const float derivative = (parameters->filter * self->derivative
        + parameters->derivative * change) / (parameters->filter + parameters->period);
    const float proportional = parameters->proportional
        * (parameters->target_weight * target - measured);
    const float wanted = proportional + self->integral + derivative;
    const float output = min_f32(max_f32(wanted, parameters->low), parameters->high);
    if (isfinite(wanted) != 0) {
        self->derivative = derivative;
        self->before = weighted;
        self->running = true;
        const float rate = parameters->integral * error;
        const float beyond = wanted - output;
        if (parameters->tracking > 0.0F) {
            self->integral += parameters->period * (rate - parameters->tracking * beyond);
        } else if (beyond * rate <= 0.0F) {
            self->integral += parameters->period * rate;
        } else {
            /* Nothing. */
        }
    }
    return output;
}

void pid_pid_f32_track(pid_pid_f32_t *BESSEMER_RESTRICT self,
    const pid_parameters_f32_t *parameters, float target, float measured, float output)
{
    const float proportional = parameters->proportional
        * (parameters->target_weight * target - measured);
    self->integral = output - proportional;
    self->derivative = 0.0F;
    self->before = parameters->target_slope_weight * target - measured;
    self->running = true;
}

/* pid_f32.h */

/**
 * PID controller.
 *
 * * Initialisation: `Default` has no integral, and no derivative in the first period. `Pid::track` starts from
 *  an output.
 * * Saturation: the output is limited to `low` … `high`; with reversed limits it is `high`.
 * * NaN or infinity: the output is a limit (`low` for NaN), and the state keeps its value.
 *
 * ```
 * use bessemer_blocks::{Pid, PidParameters};
 *
 * let parameters = PidParameters {
 *    proportional: 2.0, integral: 1.0, low: -5.0, high: 5.0, period: 0.5,
 *    ..Default::default()
 * };
 * let mut pid = Pid::default();
 * assert_eq!(pid.step(&parameters, 1.0, 0.0), 2.0);
 * assert_eq!(pid.step(&parameters, 1.0, 0.0), 2.5);
 * // The integral does not grow at the limit.
 * assert_eq!(pid.step(&parameters, 9.0, 0.0), 5.0);
 * assert_eq!(pid.step(&parameters, 1.0, 0.0), 3.0);
 * ```
 */
typedef struct {
    /** Integral part of the output. */
    float integral;
    /** Derivative part of the output. */
    float derivative;
    /** Weighted target less measurement of the last period, of which the derivative is. */
    float before;
    /** True after the first period. */
    bool running;
} pid_pid_f32_t;

/* pid_f64.c */

void pid_pid_f64_init(pid_pid_f64_t *self)
{
    self->integral = 0.0;
    self->derivative = 0.0;
    self->before = 0.0;
    self->running = false;
}

double pid_pid_f64_step(pid_pid_f64_t *BESSEMER_RESTRICT self,
    const pid_parameters_f64_t *parameters, double target, double measured)
{
    const double error = target - measured;
    const double weighted = parameters->target_slope_weight * target - measured;
    double change;
    if (self->running) {
        change = weighted - self->before;
    } else {
        change = 0.0;
    }
    const double derivative = (parameters->filter * self->derivative
        + parameters->derivative * change) / (parameters->filter + parameters->period);
    const double proportional = parameters->proportional
        * (parameters->target_weight * target - measured);
    const double wanted = proportional + self->integral + derivative;
    const double output = min_f64(max_f64(wanted, parameters->low), parameters->high);
    if (isfinite(wanted) != 0) {
        self->derivative = derivative;
        self->before = weighted;
        self->running = true;
        const double rate = parameters->integral * error;
        const double beyond = wanted - output;
        if (parameters->tracking > 0.0) {
            self->integral += parameters->period * (rate - parameters->tracking * beyond);
        } else if (beyond * rate <= 0.0) {
            self->integral += parameters->period * rate;
        } else {
            /* Nothing. */
        }
    }
    return output;
}

void pid_pid_f64_track(pid_pid_f64_t *BESSEMER_RESTRICT self,
    const pid_parameters_f64_t *parameters, double target, double measured, double output)
{
    const double proportional = parameters->proportional
        * (parameters->target_weight * target - measured);
    self->integral = output - proportional;
    self->derivative = 0.0;
    self->before = parameters->target_slope_weight * target - measured;
    self->running = true;
}

/* pid_f64.h */

/**
 * PID controller.
 *
 * * Initialisation: `Default` has no integral, and no derivative in the first period. `Pid::track` starts from
 *  an output.
 * * Saturation: the output is limited to `low` … `high`; with reversed limits it is `high`.
 * * NaN or infinity: the output is a limit (`low` for NaN), and the state keeps its value.
 *
 * ```
 * use bessemer_blocks::{Pid, PidParameters};
 *
 * let parameters = PidParameters {
 *    proportional: 2.0, integral: 1.0, low: -5.0, high: 5.0, period: 0.5,
 *    ..Default::default()
 * };
 * let mut pid = Pid::default();
 * assert_eq!(pid.step(&parameters, 1.0, 0.0), 2.0);
 * assert_eq!(pid.step(&parameters, 1.0, 0.0), 2.5);
 * // The integral does not grow at the limit.
 * assert_eq!(pid.step(&parameters, 9.0, 0.0), 5.0);
 * assert_eq!(pid.step(&parameters, 1.0, 0.0), 3.0);
 * ```
 */
typedef struct {
    /** Integral part of the output. */
    double integral;
    /** Derivative part of the output. */
    double derivative;
    /** Weighted target less measurement of the last period, of which the derivative is. */
    double before;
    /** True after the first period. */
    bool running;
} pid_pid_f64_t;
