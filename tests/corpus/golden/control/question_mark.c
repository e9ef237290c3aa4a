/* The C of tests/corpus/src/programs/control/question_mark.rs. Written by a test. */

/* question_mark.c */

void question_mark_voltage(uint16_t count, result_f64_failure_t *result)
{
    if (count <= 9U) {
        *result = (result_f64_failure_t){.is_ok = false, .error = FAILURE_SHORT};
    } else if (count >= 4000U) {
        *result = (result_f64_failure_t){.is_ok = false, .error = FAILURE_OPEN};
    } else {
        *result = (result_f64_failure_t){.is_ok = true, .value = (double)count / 1000.0};
    }
}

void question_mark_power(uint16_t volts, uint16_t amperes, result_f64_failure_t *result)
{
    result_f64_failure_t u_outcome;
    question_mark_voltage(volts, &u_outcome);
    if (!u_outcome.is_ok) {
        *result = (result_f64_failure_t){.is_ok = false, .error = u_outcome.error};
        return;
    }
    const double u = u_outcome.value;
    result_f64_failure_t i_outcome;
    question_mark_voltage(amperes, &i_outcome);
    if (!i_outcome.is_ok) {
        *result = (result_f64_failure_t){.is_ok = false, .error = i_outcome.error};
        return;
    }
    const double i = i_outcome.value;
    *result = (result_f64_failure_t){.is_ok = true, .value = u * i};
}

/* question_mark.h */

/** Reason why there is no voltage. */
typedef enum {
    FAILURE_OPEN = 0,
    FAILURE_SHORT = 1
} failure_t;

/** `Result<f64, Failure>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** The value, if there is one. */
    double value;
    /** Reason why there is no value. */
    failure_t error;
} result_f64_failure_t;
