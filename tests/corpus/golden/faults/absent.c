/* The C of tests/corpus/src/programs/faults/absent.rs. Written by a test. */

/* absent.c */

void absent_init(absent_t *self)
{
    self->last.is_some = false;
    self->last.value = 0.0;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t absent_delayed(absent_t *BESSEMER_RESTRICT self, const option_f64_t *next,
    double *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    const option_f64_t before = self->last;
    self->last = *next;
    if (!before.is_some) {
        self->fault = BESSEMER_STATUS_ABSENT;
        return BESSEMER_STATUS_ABSENT;
    }
    *result = before.value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t absent_taken(absent_t *BESSEMER_RESTRICT self, double *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    const option_f64_t result_before = self->last;
    self->last = (option_f64_t){.is_some = false};
    if (!result_before.is_some) {
        self->fault = BESSEMER_STATUS_ABSENT;
        return BESSEMER_STATUS_ABSENT;
    }
    *result = result_before.value;
    return BESSEMER_STATUS_OK;
}

/* absent.h */

/** Stores the last value. */
typedef struct {
    option_f64_t last;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} absent_t;
