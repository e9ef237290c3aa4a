/* The C of tests/corpus/src/programs/matrices/error_state.rs. Written by a test. */

/* error_state.c */

void pointing_difference(const pointing_t *self, const pointing_t *from,
    double errors[BESSEMER_RESTRICT 6])
{
    unit_quaternion_f64_t attitude_change_first;
    unit_quaternion_inverse_f64(&from->attitude, &attitude_change_first);
    unit_quaternion_f64_t attitude_change;
    unit_quaternion_product_f64(&attitude_change_first, &self->attitude, &attitude_change);
    double attitude_turn[3];
    rotation_scaled_axis_f64(&attitude_change, attitude_turn);
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[ERROR_STATE_POINTING_ATTITUDE + n] = attitude_turn[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[ERROR_STATE_POINTING_BIAS + n] = self->bias[n] - from->bias[n];
    }
}

void pointing_retracted(const pointing_t *self, const double errors[6],
    pointing_t *BESSEMER_RESTRICT moved)
{
    *moved = *self;
    const double attitude_turn[3] = {
        errors[ERROR_STATE_POINTING_ATTITUDE], errors[ERROR_STATE_POINTING_ATTITUDE + 1U],
        errors[ERROR_STATE_POINTING_ATTITUDE + 2U]
    };
    unit_quaternion_f64_t attitude_second;
    rotation_from_scaled_axis_f64(attitude_turn, &attitude_second);
    unit_quaternion_product_f64(&self->attitude, &attitude_second, &moved->attitude);
    for (uint32_t n = 0U; n < 3U; n++) {
        moved->bias[n] += errors[ERROR_STATE_POINTING_BIAS + n];
    }
}

/* error_state.h */

/** Attitude and bias of a gyroscope. */
typedef struct {
    /** From the body's frame to the world's. */
    unit_quaternion_f64_t attitude;
    /** Bias of the measured rates, rad/s. */
    double bias[3];
} pointing_t;

/** Working memory of its entry point; the contents are undefined between calls. */
typedef struct {
    double numbers[72];
} pointing_filter_predict_work_t;

/* pointing_filter.c */

void pointing_filter_init(pointing_filter_t *self)
{
    self->state.attitude.i = 0.0;
    self->state.attitude.j = 0.0;
    self->state.attitude.k = 0.0;
    self->state.attitude.w = 1.0;
    self->state.bias[0] = 0.0;
    self->state.bias[1] = 0.0;
    self->state.bias[2] = 0.0;
    for (uint32_t i = 0U; i < 36U; i++) {
        self->covariance.elements[i] = 0.0;
    }
    self->covariance.elements[0 + 6 * 0] = 0.1;
    self->covariance.elements[1 + 6 * 1] = 0.1;
    self->covariance.elements[2 + 6 * 2] = 0.1;
    self->covariance.elements[3 + 6 * 3] = 0.001;
    self->covariance.elements[4 + 6 * 4] = 0.001;
    self->covariance.elements[5 + 6 * 5] = 0.001;
}

void pointing_filter_predict(pointing_filter_t *BESSEMER_RESTRICT self, const double rates[3],
    double period, pointing_filter_predict_work_t *BESSEMER_RESTRICT work)
{
    const double turn[3] = {
        (rates[0] - self->state.bias[0]) * period,
        (rates[1] - self->state.bias[1]) * period,
        (rates[2] - self->state.bias[2]) * period
    };
    unit_quaternion_f64_t step;
    rotation_from_scaled_axis_f64(turn, &step);
    unit_quaternion_f64_t attitude_next;
    unit_quaternion_product_f64(&self->state.attitude, &step, &attitude_next);
    self->state.attitude = attitude_next;

    /* The errors are in the body's frame, which moves away from them. */
    unit_quaternion_f64_t back_q;
    unit_quaternion_inverse_f64(&step, &back_q);
    double back[9];
    unit_quaternion_to_rotation_matrix_f64(&back_q, back);
    double *const jacobian = work->numbers;
    (void)memcpy(jacobian, BESSEMER_IDENTITY_6, sizeof(double[36]));
    for (uint32_t row = 0U; row < 3U; row++) {
        for (uint32_t col = 0U; col < 3U; col++) {
            jacobian[ERROR_STATE_POINTING_ATTITUDE + row + 6U * (ERROR_STATE_POINTING_ATTITUDE + col)] = back[row + 3U * col];
        }
        jacobian[ERROR_STATE_POINTING_ATTITUDE + row + 6U * (ERROR_STATE_POINTING_BIAS + row)] = -period;
    }
    symmetric_f64_6_congruence(&self->covariance, jacobian, &work->numbers[36]);
    const double wander = 1e-6 * period;
    const double drift = 1e-8 * period;
    const double values[6] = {wander, wander, wander, drift, drift, drift};
    symmetric_f64_6_add_diagonal(&self->covariance, values);
}

void pointing_filter_measure(pointing_filter_t *BESSEMER_RESTRICT self, const double known[3],
    const double measured[3], correction_f64_t *BESSEMER_RESTRICT report)
{
    unit_quaternion_f64_t expected_q;
    unit_quaternion_inverse_f64(&self->state.attitude, &expected_q);
    double expected[3];
    unit_quaternion_transform_vector_f64(&expected_q, known, expected);

    /* A small turn δ of the body changes what it sees of v by v × δ. */
    double cross[9];
    parts_cross_matrix_f64(expected, cross);
    double jacobian[18] = {0};
    for (uint32_t row = 0U; row < 3U; row++) {
        for (uint32_t col = 0U; col < 3U; col++) {
            jacobian[row + 3U * (ERROR_STATE_POINTING_ATTITUDE + col)] = cross[row + 3U * col];
        }
    }
    const double noise_values[3] = {0.0001, 0.0001, 0.0001};
    symmetric_f64_3_t noise;
    symmetric_f64_3_diagonal(noise_values, &noise);
    double errors[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double report_innovation[3] = {
        measured[0] - expected[0],
        measured[1] - expected[1],
        measured[2] - expected[2]
    };
    symmetric_f64_6_correct_jointly_3(&self->covariance, errors, jacobian, report_innovation,
        &noise, 100.0, report);
    pointing_t state_next;
    pointing_retracted(&self->state, errors, &state_next);
    self->state = state_next;
}

/* pointing_filter.h */

/** A filter of the errors of attitude and bias. */
typedef struct {
    /** Attitude and bias. */
    pointing_t state;
    /** Covariance of their errors. */
    symmetric_f64_6_t covariance;
} pointing_filter_t;
