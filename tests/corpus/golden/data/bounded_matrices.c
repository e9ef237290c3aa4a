/* The C of tests/corpus/src/programs/data/bounded_matrices.rs. Written by a test. */

/* measured.c */

void measured_init(measured_t *self)
{
    self->values.rows = UINT64_C(0);
    self->values.columns = UINT64_C(0);
    self->values.elements[0][0] = 0.0;
    self->values.elements[0][1] = 0.0;
    self->values.elements[0][2] = 0.0;
    self->values.elements[0][3] = 0.0;
    self->values.elements[1][0] = 0.0;
    self->values.elements[1][1] = 0.0;
    self->values.elements[1][2] = 0.0;
    self->values.elements[1][3] = 0.0;
    self->values.elements[2][0] = 0.0;
    self->values.elements[2][1] = 0.0;
    self->values.elements[2][2] = 0.0;
    self->values.elements[2][3] = 0.0;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t measured_resize(measured_t *self, uint64_t sensors, uint64_t times)
{
    bessemer_status_t status;
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    status = bounded_matrix_f64_4_3_resize(&self->values, sensors, times, 0.0);
    if (status != BESSEMER_STATUS_OK) {
        self->fault = status;
        return status;
    }
    return BESSEMER_STATUS_OK;
}

bessemer_status_t measured_keep(measured_t *self, uint64_t sensor, uint64_t time, double value)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if (self->values.rows > UINT64_C(4) || self->values.columns > UINT64_C(3)
            || sensor >= self->values.rows || time >= self->values.columns) {
        self->fault = BESSEMER_STATUS_INDEX;
        return BESSEMER_STATUS_INDEX;
    }
    self->values.elements[time][sensor] = value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t measured_products(measured_t *BESSEMER_RESTRICT self,
    bounded_matrix_f64_4_4_t *BESSEMER_RESTRICT bounded_matrix_f64_4_4)
{
    bessemer_status_t status;
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    bounded_matrix_f64_3_4_t bounded_matrix_f64_4_4_other;
    bounded_matrix_f64_4_3_transpose(&self->values, &bounded_matrix_f64_4_4_other);
    status = bounded_matrix_f64_4_3_mul_bounded_matrix_f64_3_4(&self->values,
        &bounded_matrix_f64_4_4_other, bounded_matrix_f64_4_4);
    if (status != BESSEMER_STATUS_OK) {
        self->fault = status;
        return status;
    }
    return BESSEMER_STATUS_OK;
}

bessemer_status_t measured_limited(measured_t *BESSEMER_RESTRICT self, double most,
    double *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    const uint32_t value_rows = (uint32_t)min_u64(self->values.rows, UINT64_C(4));
    const uint32_t value_columns = (uint32_t)min_u64(self->values.columns, UINT64_C(3));
    for (uint32_t column = 0U; column < value_columns; column++) {
        bool loop_done = false;
        for (uint32_t row = 0U; row < value_rows; row++) {
            if (self->values.elements[column][row] < 0.0) {
                loop_done = true;
                break;
            }
            self->values.elements[column][row] = min_f64(self->values.elements[column][row], most);
        }
        if (loop_done) {
            break;
        }
    }
    double largest = 0.0;
    const uint32_t result_rows = (uint32_t)min_u64(self->values.rows, UINT64_C(4));
    const uint32_t result_columns = (uint32_t)min_u64(self->values.columns, UINT64_C(3));
    for (uint32_t column = 0U; column < result_columns; column++) {
        for (uint32_t row = 0U; row < result_rows; row++) {
            largest = max_f64(largest, self->values.elements[column][row]);
        }
    }
    *result = largest;
    return BESSEMER_STATUS_OK;
}

/* measured.h */

/** Measurements of up to four sensors at up to three times. */
typedef struct {
    bounded_matrix_f64_4_3_t values;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} measured_t;
