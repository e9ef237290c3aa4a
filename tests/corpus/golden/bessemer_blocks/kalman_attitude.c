/* The C of blocks/src/kalman_attitude.rs. Written by a test. */

/* error_state_filter_f64.c */

void error_state_filter_f64_init(error_state_filter_f64_t *self)
{
    self->attitude.i = 0.0;
    self->attitude.j = 0.0;
    self->attitude.k = 0.0;
    self->attitude.w = 1.0;
    self->bias[0] = 0.0;
    self->bias[1] = 0.0;
    self->bias[2] = 0.0;
    for (uint32_t i = 0U; i < 36U; i++) {
        self->covariance.elements[i] = 0.0;
    }
    self->covariance.elements[0 + 6 * 0] = 0.09;
    self->covariance.elements[1 + 6 * 1] = 0.09;
    self->covariance.elements[2 + 6 * 2] = 0.09;
    self->covariance.elements[3 + 6 * 3] = 0.0009;
    self->covariance.elements[4 + 6 * 4] = 0.0009;
    self->covariance.elements[5 + 6 * 5] = 0.0009;
}

void error_state_filter_f64_step(error_state_filter_f64_t *BESSEMER_RESTRICT self,
    const error_state_noise_f64_t *noise, const double rates[3], const double force[3],
    error_state_filter_f64_step_work_t *BESSEMER_RESTRICT work,
    unit_quaternion_f64_t *BESSEMER_RESTRICT unit_quaternion)
{
    error_state_filter_f64_predict(self, noise, rates, &work->error_state_filter_f64_predict);
    const double direction[3] = {0.0, 0.0, 1.0};
    {
        correction_f64_t unused;
        error_state_filter_f64_correct(self, direction, force, noise->force, noise->gate, &unused);
    }
    *unit_quaternion = self->attitude;
}

void error_state_filter_f64_predict(error_state_filter_f64_t *BESSEMER_RESTRICT self,
    const error_state_noise_f64_t *noise, const double rates[3],
    error_state_filter_f64_predict_work_t *BESSEMER_RESTRICT work)
{
    const double turn[3] = {
        (rates[0] - self->bias[0]) * noise->period,
        (rates[1] - self->bias[1]) * noise->period,
        (rates[2] - self->bias[2]) * noise->period
    };
    if (isfinite(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]) == 0) {
        return;
    }
    unit_quaternion_f64_t turned;
    rotation_from_scaled_axis_f64(turn, &turned);
    unit_quaternion_f64_t back_q;
    unit_quaternion_inverse_f64(&turned, &back_q);
    double back[9];
    unit_quaternion_to_rotation_matrix_f64(&back_q, back);
    double *const jacobian = work->numbers;
    (void)memcpy(jacobian, BESSEMER_IDENTITY_6, sizeof(double[36]));
    for (uint32_t row = 0U; row < 3U; row++) {
        for (uint32_t column = 0U; column < 3U; column++) {
            jacobian[row + 6U * column] = back[row + 3U * column];
        }
        jacobian[row + 6U * (row + 3U)] = -noise->period;
    }
    unit_quaternion_f64_t unit_quaternion;
    unit_quaternion_product_f64(&self->attitude, &turned, &unit_quaternion);
    const quaternion_f64_t attitude_q = {
        .i = unit_quaternion.i,
        .j = unit_quaternion.j,
        .k = unit_quaternion.k,
        .w = unit_quaternion.w
    };
    unit_quaternion_new_normalize_f64(&attitude_q, &self->attitude);
    symmetric_f64_6_congruence(&self->covariance, jacobian, &work->numbers[36]);
    const double angle = noise->rates * noise->period;
    const double rate = noise->drift * noise->period;
    const double values[6] = {angle, angle, angle, rate, rate, rate};
    symmetric_f64_6_add_diagonal(&self->covariance, values);
}

void error_state_filter_f64_correct(error_state_filter_f64_t *BESSEMER_RESTRICT self,
    const double direction[3], const double measured[3], double variance, double gate,
    correction_f64_t *BESSEMER_RESTRICT found)
{
    const double length = sqrt(measured[0] * measured[0] + measured[1] * measured[1]
        + measured[2] * measured[2]);
    if (!(length > 0.0 && isfinite(length) != 0)) {
        found->surprise = 0.0;
        found->status = CORRECT_STATUS_REJECTED;
        return;
    }
    double expected[3];
    unit_quaternion_inverse_transform_vector_f64(&self->attitude, direction, expected);
    double across[9];
    parts_cross_matrix_f64(expected, across);
    double jacobian[18] = {0};
    for (uint32_t row = 0U; row < 3U; row++) {
        for (uint32_t column = 0U; column < 3U; column++) {
            jacobian[row + 3U * column] = across[row + 3U * column];
        }
    }
    const double innovation[3] = {
        measured[0] / length - expected[0],
        measured[1] / length - expected[1],
        measured[2] / length - expected[2]
    };
    double noise_values[3];
    noise_values[0] = variance;
    noise_values[1] = variance;
    noise_values[2] = variance;
    symmetric_f64_3_t noise;
    symmetric_f64_3_diagonal(noise_values, &noise);
    double errors[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    correction_f64_t found_value;
    symmetric_f64_6_correct_jointly_3(&self->covariance, errors, jacobian, innovation, &noise, gate,
        &found_value);
    const double turn_axis[3] = {errors[0], errors[1], errors[2]};
    unit_quaternion_f64_t turn;
    rotation_from_scaled_axis_f64(turn_axis, &turn);
    unit_quaternion_f64_t unit_quaternion;
    unit_quaternion_product_f64(&self->attitude, &turn, &unit_quaternion);
    const quaternion_f64_t attitude_q = {
        .i = unit_quaternion.i,
        .j = unit_quaternion.j,
        .k = unit_quaternion.k,
        .w = unit_quaternion.w
    };
    unit_quaternion_new_normalize_f64(&attitude_q, &self->attitude);
    self->bias[0] += errors[3];
    self->bias[1] += errors[4];
    self->bias[2] += errors[5];
    *found = found_value;
}

void error_state_filter_f64_bias(const error_state_filter_f64_t *self,
    double result[BESSEMER_RESTRICT 3])
{
    result[0] = self->bias[0];
    result[1] = self->bias[1];
    result[2] = self->bias[2];
}

/* error_state_filter_f64.h */

/**
 * Error-state Kalman filter: gyroscope, accelerometer, and other directions such as the magnetic field.
 *
 * The state is an attitude q and a bias b, their errors a rotation vector ε in the body's frame and a difference:
 * q ⊗ exp(ε/2) and b + β are the truth. A period rotates q by (ω − b) h, with ε' = R((ω − b) h)ᵀ ε − h β. A measured
 * direction m of one that is d in the world gives ν = m − v and H = ([v]×, 0), with the estimate v = R(q)ᵀ d. The errors
 * become part of the state, and are 0 again. A force of 0 gives no correction; samples that are not finite are ignored.
 * Initialisation: `ErrorStateFilter::begin`; `Default` is level and without bias, with standard deviations of 0.3 rad and
 * 0.03 rad/s. Source: Solà, *Quaternion kinematics for the error-state Kalman filter*, 2017, sections 5 and 6.
 *
 * ```
 * use bessemer_blocks::{ErrorStateFilter, ErrorStateNoise};
 * use bessemer::nalgebra::Vector3;
 *
 * let noise = ErrorStateNoise { rates: 1e-6, drift: 1e-8, force: 1e-4, gate: 1e6, period: 0.01_f64 };
 * let mut filter = ErrorStateFilter::default();
 * let (tilted, bias) = (Vector3::new(0.0, 0.6, 0.8), Vector3::new(0.02, 0.0, 0.0));
 * for _ in 0..2000 {
 *    filter.step(&noise, &bias, &tilted);
 * }
 * assert!((filter.up() - tilted).norm() < 1e-3);
 * assert!((filter.bias() - bias).norm() < 1e-3);
 * ```
 */
typedef struct {
    /** The attitude. */
    unit_quaternion_f64_t attitude;
    /** Bias of the gyroscope. Unit: rad/s. */
    double bias[3];
    /** Covariance of the errors: three of the attitude, three of the bias. */
    symmetric_f64_6_t covariance;
} error_state_filter_f64_t;

/* kalman_attitude.h */

/** Noise of the sensors of an `ErrorStateFilter`. */
typedef struct {
    /** Density of the rates' noise, 0 or more. Unit: rad²/s. */
    double rates;
    /** Density of the bias's drift, 0 or more. Unit: rad²/s³. */
    double drift;
    /** Variance of the force over its length, above 0: of vibration and accelerations. */
    double force;
    /**
     * Surprise above which a force is rejected: about 16, since a force of three numbers has 3 on average.
     */
    double gate;
    /** Period, above 0. Unit: s. */
    double period;
} error_state_noise_f64_t;

/** Working memory of its entry point; the contents are undefined between calls. */
typedef struct {
    double numbers[72];
} error_state_filter_f64_predict_work_t;

/** Working memory of its entry point; the contents are undefined between calls. */
typedef struct {
    error_state_filter_f64_predict_work_t error_state_filter_f64_predict;
} error_state_filter_f64_step_work_t;
