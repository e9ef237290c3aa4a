/* The C of tests/corpus/src/programs/control/question_mark.rs. Written by a test. */

/* question_mark.c */

void question_mark_voltage(uint16_t count, result_f64_failure_t *result)
{
    if (count <= 9U) {
        result->is_ok = false;
        result->as.error = FAILURE_SHORT;
    } else if (count >= 4000U) {
        result->is_ok = false;
        result->as.error = FAILURE_OPEN;
    } else {
        result->is_ok = true;
        result->as.value = (double)count / 1000.0;
    }
}

void question_mark_power(uint16_t volts, uint16_t amperes, result_f64_failure_t *result)
{
    result_f64_failure_t u_outcome;
    question_mark_voltage(volts, &u_outcome);
    if (!u_outcome.is_ok) {
        result->is_ok = false;
        result->as.error = u_outcome.as.error;
        return;
    }
    const double u = u_outcome.as.value;
    result_f64_failure_t i_outcome;
    question_mark_voltage(amperes, &i_outcome);
    if (!i_outcome.is_ok) {
        result->is_ok = false;
        result->as.error = i_outcome.as.error;
        return;
    }
    const double i = i_outcome.as.value;
    result->is_ok = true;
    result->as.value = u * i;
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
    /** What it holds. */
    union {
        /** The value, if there is one. */
        double value;
        /** Reason why there is no value. */
        failure_t error;
    } as;
} result_f64_failure_t;
