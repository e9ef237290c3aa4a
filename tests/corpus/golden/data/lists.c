/* The C of tests/corpus/src/programs/data/lists.rs. Written by a test. */

/* lists.c */

void lists_init(lists_t *self)
{
    self->values.length = UINT64_C(0);
    self->values.items[0] = 0.0;
    self->values.items[1] = 0.0;
    self->values.items[2] = 0.0;
    self->values.items[3] = 0.0;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t lists_keep(lists_t *self, double value)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if (self->values.length >= UINT64_C(4)) {
        self->fault = BESSEMER_STATUS_CAPACITY;
        return BESSEMER_STATUS_CAPACITY;
    }
    self->values.items[self->values.length] = value;
    self->values.length += UINT64_C(1);
    return BESSEMER_STATUS_OK;
}

void lists_mean(lists_t *BESSEMER_RESTRICT self, option_f64_t *BESSEMER_RESTRICT result)
{
    double sum = 0.0;
    {
        const uint32_t end = (uint32_t)min_u64(self->values.length, UINT64_C(4));
        for (uint32_t i = 0U; i < end; i++) {
            sum += self->values.items[i];
        }
    }
    if (self->values.length == UINT64_C(0)) {
        *result = (option_f64_t){.is_some = false};
    } else {
        result->is_some = true;
        result->value = sum / (double)self->values.length;
    }
}

void lists_last(lists_t *BESSEMER_RESTRICT self, option_f64_t *BESSEMER_RESTRICT result)
{
    *result = (option_f64_t){.is_some = false};
    if (self->values.length > UINT64_C(0) && self->values.length <= UINT64_C(4)) {
        self->values.length -= UINT64_C(1);
        result->is_some = true;
        result->value = self->values.items[self->values.length];
    }
}

/* lists.h */

/** The values of the last periods. */
typedef struct {
    list4_f64_t values;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} lists_t;
