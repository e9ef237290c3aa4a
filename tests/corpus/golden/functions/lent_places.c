/* The C of tests/corpus/src/programs/functions/lent_places.rs. Written by a test. */

/* lent_places.c */

double axis_command(const axis_t *self, double error)
{
    return min_f64(self->gain * error, self->limit);
}

void axis_widen(axis_t *self, double by)
{
    self->limit += by;
}

bessemer_status_t head_wider(const head_t *self, uint64_t i, uint64_t j,
    axis_t *BESSEMER_RESTRICT axis)
{
    if (i >= UINT64_C(3)) {
        return BESSEMER_STATUS_INDEX;
    }
    if (j >= UINT64_C(3)) {
        return BESSEMER_STATUS_INDEX;
    }
    if (self->axes[i].limit > self->axes[j].limit) {
        *axis = self->axes[i];
        return BESSEMER_STATUS_OK;
    } else {
        *axis = self->axes[j];
        return BESSEMER_STATUS_OK;
    }
}

bessemer_status_t lent_places_commanded(const head_t *head, uint64_t i, double error,
    double *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    if (i >= UINT64_C(3)) {
        return BESSEMER_STATUS_INDEX;
    }
    const double result_command = axis_command(&head->axes[i], error);
    if (head->main >= UINT64_C(3)) {
        return BESSEMER_STATUS_INDEX;
    }
    axis_t axis;
    status = head_wider(head, UINT64_C(0), i, &axis);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    *result = result_command + head->axes[head->main].gain + axis.limit;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t lent_places_widened(head_t *head, uint64_t i, double by)
{
    if (i <= UINT64_C(0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    if (i >= UINT64_C(3)) {
        return BESSEMER_STATUS_INDEX;
    }
    head->axes[i].gain = by;
    axis_widen(&head->axes[1], by);
    for (uint32_t k = 1U; k < 3U; k++) {
        head->axes[k].limit *= 2.0;
    }
    axis_widen(&head->axes[2], by);
    head->axes[2].gain -= 1.0;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t lent_places_behind(const double values[], uint64_t values_length,
    const double other[], uint64_t other_length, uint64_t i, double *BESSEMER_RESTRICT result)
{
    if (i < values_length) {
        *result = values[i];
        return BESSEMER_STATUS_OK;
    } else {
        if (i - values_length >= other_length) {
            return BESSEMER_STATUS_INDEX;
        }
        *result = other[i - values_length];
        return BESSEMER_STATUS_OK;
    }
}

bessemer_status_t lent_places_joined(const double left[3], const double right[2], uint64_t i,
    double *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    double result_behind;
    status = lent_places_behind(left, UINT64_C(3), right, UINT64_C(2), i, &result_behind);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    double result_behind_2;
    status = lent_places_behind(right, UINT64_C(2), left, UINT64_C(3), UINT64_C(0),
        &result_behind_2);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    *result = result_behind - result_behind_2;
    return BESSEMER_STATUS_OK;
}

/* lent_places.h */

/** One of three axes. */
typedef struct {
    double gain;
    double limit;
} axis_t;

/** Three axes, and the index of the main one. */
typedef struct {
    axis_t axes[3];
    uint64_t main;
} head_t;
