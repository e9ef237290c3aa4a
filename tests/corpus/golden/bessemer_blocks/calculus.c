/* The C of blocks/src/calculus.rs. Written by a test. */

/* calculus.h */

/** Limits of an `Integrator`. `Default` has no limits and a period of 1 s. */
typedef struct {
    /** Lowest output. */
    double low;
    /** Highest output, not below the lowest. */
    double high;
    /** Period h, above 0. Unit: s. */
    double period;
} integrator_parameters_f64_t;

/* derivative_f64.c */

void derivative_f64_init(derivative_f64_t *self)
{
    self->slope = 0.0;
    self->before = 0.0;
    self->running = false;
}

double derivative_f64_step(derivative_f64_t *self, double time_constant, double period,
    double sample)
{
    if (isfinite(sample) != 0) {
        if (self->running) {
            const double change = sample - self->before;
            self->slope = (time_constant * self->slope + change) / (time_constant + period);
        }
        self->before = sample;
        self->running = true;
    }
    return self->slope;
}

/* derivative_f64.h */

/**
 * Derivative with a filter of first order: s/(τ s + 1) by the backward difference.
 *
 * d(k) = (τ d(k−1) + u(k) − u(k−1)) / (τ + h), for a time constant τ in s, 0 or more, and a period h in s, above 0.
 *
 * Initialisation: the first sample has the derivative 0. Nothing saturates. An input that is not finite returns the
 * last derivative and changes nothing. Source: Åström and Hägglund, *Advanced PID Control*, 2006, section 13.
 *
 * ```
 * let mut derivative = bessemer_blocks::Derivative::default();
 * assert_eq!([1.0, 1.5, 2.0].map(|sample| derivative.step(0.0, 0.5, sample)), [0.0, 1.0, 1.0]);
 * ```
 */
typedef struct {
    /** The last derivative. */
    double slope;
    /** The last sample. */
    double before;
    /** True after the first sample. */
    bool running;
} derivative_f64_t;

/* integrator_f64.c */

void integrator_f64_init(integrator_f64_t *self)
{
    self->sum = 0.0;
    self->before = 0.0;
    self->running = false;
}

double integrator_f64_step(integrator_f64_t *BESSEMER_RESTRICT self,
    const integrator_parameters_f64_t *parameters, double sample)
{
    if (isfinite(sample) != 0) {
        if (self->running) {
            const double half = 0.5 * parameters->period;
            const double sum = self->sum + half * (sample + self->before);
            self->sum = min_f64(max_f64(sum, parameters->low), parameters->high);
        }
        self->before = sample;
        self->running = true;
    }
    return self->sum;
}

void integrator_f64_reset(integrator_f64_t *self, double value)
{
    self->sum = value;
    self->running = false;
}

/* integrator_f64.h */

/**
 * Integral by the trapezoidal rule: y(k) = y(k−1) + h/2 (u(k) + u(k−1)).
 *
 * Saturation: the output, which is the state, is limited to `low` … `high`, so it leaves a limit at once.
 * Initialisation: `Default` begins at 0; the first sample adds nothing. `Integrator::reset` begins at a value. An
 * input that is not finite adds nothing.
 *
 * ```
 * use bessemer_blocks::{Integrator, IntegratorParameters};
 *
 * let parameters = IntegratorParameters { low: 0.0, high: 10.0, period: 2.0 };
 * let mut integrator = Integrator::default();
 * assert_eq!([1.0, 3.0, 9.0, -1.0].map(|sample| integrator.step(&parameters, sample)), [0.0, 4.0, 10.0, 10.0]);
 * ```
 */
typedef struct {
    /** The integral. */
    double sum;
    /** The last sample. */
    double before;
    /** True after the first sample. */
    bool running;
} integrator_f64_t;
