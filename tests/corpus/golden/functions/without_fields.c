/* The C of tests/corpus/src/programs/functions/without_fields.rs. Written by a test. */

/* trapezoid_integral.c */

void trapezoid_integral_init(trapezoid_integral_t *self)
{
    self->last = 0.0;
    self->sum = 0.0;
}

double trapezoid_integral_step(trapezoid_integral_t *self, double sample)
{
    self->sum += without_fields_trapezoid_area(self->last, sample, 0.01);
    self->last = sample;
    return self->sum;
}

/* trapezoid_integral.h */

/** The integral that flies. */
typedef struct {
    double last;
    double sum;
} trapezoid_integral_t;

/* without_fields.c */

static double without_fields_areas_rectangle(const double samples[4]);
static double without_fields_areas_trapezoid(const double samples[4]);

double without_fields_trapezoid_area(double left, double right, double step)
{
    return 0.5 * (left + right) * step;
}

double without_fields_rectangle_area(double left, double right, double step)
{
    (void)right;
    return left * step;
}

without_fields_trouble_t without_fields_trouble_from_saturated(void)
{
    return WITHOUT_FIELDS_TROUBLE_HIGH;
}

void without_fields_commanded(double torque, result_f64_without_fields_saturated_t *result)
{
    if (torque > 2.0) {
        *result = (result_f64_without_fields_saturated_t){.is_ok = false};
    } else {
        result->is_ok = true;
        result->value = torque;
    }
}

void without_fields_limited(double torque, result_f64_without_fields_trouble_t *result)
{
    result_f64_without_fields_saturated_t torque_outcome;
    without_fields_commanded(torque, &torque_outcome);
    if (!torque_outcome.is_ok) {
        result->is_ok = false;
        result->as.error = without_fields_trouble_from_saturated();
        return;
    }
    const double torque_2 = torque_outcome.value;
    if (torque_2 < -2.0) {
        result->is_ok = false;
        result->as.error = WITHOUT_FIELDS_TROUBLE_LOW;
    } else {
        result->is_ok = true;
        result->as.value = torque_2;
    }
}

static double without_fields_areas_rectangle(const double samples[4])
{
    double sum = -0.0;
    for (uint32_t i = 0U; i < 3U; i++) {
        sum += without_fields_rectangle_area(samples[i], samples[i + 1U], 0.5);
    }
    return sum;
}

static double without_fields_areas_trapezoid(const double samples[4])
{
    double sum = -0.0;
    for (uint32_t i = 0U; i < 3U; i++) {
        sum += without_fields_trapezoid_area(samples[i], samples[i + 1U], 0.5);
    }
    return sum;
}

void without_fields_compared(const double samples[4], double result[BESSEMER_RESTRICT 2])
{
    result[0] = without_fields_areas_trapezoid(samples);
    result[1] = without_fields_areas_rectangle(samples);
}

/* without_fields.h */

/** Errors of a value out of range. */
typedef enum {
    /** Above the upper limit. */
    WITHOUT_FIELDS_TROUBLE_HIGH = 0,
    /** Below the lower limit. */
    WITHOUT_FIELDS_TROUBLE_LOW = 1
} without_fields_trouble_t;

/** `Result<f64, Trouble>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        double value;
        /** Reason why there is no value. */
        without_fields_trouble_t error;
    } as;
} result_f64_without_fields_trouble_t;
