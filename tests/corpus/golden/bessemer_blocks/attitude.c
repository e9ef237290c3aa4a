/* The C of blocks/src/attitude.rs. Written by a test. */

/* attitude.c */

void attitude_attitude_error_f32(const unit_quaternion_f32_t *attitude,
    const unit_quaternion_f32_t *target, float result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f32_t error_first;
    unit_quaternion_inverse_f32(attitude, &error_first);
    unit_quaternion_f32_t error;
    unit_quaternion_product_f32(&error_first, target, &error);
    float sign;
    if (error.w < 0.0F) {
        sign = -2.0F;
    } else {
        sign = 2.0F;
    }
    result[0] = error.i * sign;
    result[1] = error.j * sign;
    result[2] = error.k * sign;
}

void attitude_attitude_error_f64(const unit_quaternion_f64_t *attitude,
    const unit_quaternion_f64_t *target, double result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f64_t error_first;
    unit_quaternion_inverse_f64(attitude, &error_first);
    unit_quaternion_f64_t error;
    unit_quaternion_product_f64(&error_first, target, &error);
    double sign;
    if (error.w < 0.0) {
        sign = -2.0;
    } else {
        sign = 2.0;
    }
    result[0] = error.i * sign;
    result[1] = error.j * sign;
    result[2] = error.k * sign;
}

void attitude_attitude_torque_f32(const attitude_gains_f32_t *gains,
    const unit_quaternion_f32_t *attitude, const float rates[3],
    const unit_quaternion_f32_t *target, const float target_rates[3],
    float result[BESSEMER_RESTRICT 3])
{
    float error[3];
    attitude_attitude_error_f32(attitude, target, error);
    const float gyroscopic_product[3] = {
        gains->inertia[0 + 3 * 0] * rates[0] + gains->inertia[0 + 3 * 1] * rates[1]
            + gains->inertia[0 + 3 * 2] * rates[2],
        gains->inertia[1 + 3 * 0] * rates[0] + gains->inertia[1 + 3 * 1] * rates[1]
            + gains->inertia[1 + 3 * 2] * rates[2],
        gains->inertia[2 + 3 * 0] * rates[0] + gains->inertia[2 + 3 * 1] * rates[1]
            + gains->inertia[2 + 3 * 2] * rates[2]
    };
    const float gyroscopic[3] = {
        rates[1] * gyroscopic_product[2] - rates[2] * gyroscopic_product[1],
        rates[2] * gyroscopic_product[0] - rates[0] * gyroscopic_product[2],
        rates[0] * gyroscopic_product[1] - rates[1] * gyroscopic_product[0]
    };
    result[0] = gains->stiffness[0] * error[0] - gains->damping[0] * (rates[0] - target_rates[0])
        + gyroscopic[0];
    result[1] = gains->stiffness[1] * error[1] - gains->damping[1] * (rates[1] - target_rates[1])
        + gyroscopic[1];
    result[2] = gains->stiffness[2] * error[2] - gains->damping[2] * (rates[2] - target_rates[2])
        + gyroscopic[2];
}

void attitude_up_f32(const unit_quaternion_f32_t *attitude, float result[BESSEMER_RESTRICT 3])
{
    const float w = attitude->w;
    const float x = attitude->i;
    const float y = attitude->j;
    const float z = attitude->k;
    const float two = 2.0F;
    result[0] = two * (x * z - w * y);
    result[1] = two * (y * z + w * x);
    result[2] = w * w - x * x - y * y + z * z;
}

void attitude_up_f64(const unit_quaternion_f64_t *attitude, double result[BESSEMER_RESTRICT 3])
{
    const double w = attitude->w;
    const double x = attitude->i;
    const double y = attitude->j;
    const double z = attitude->k;
    const double two = 2.0;
    result[0] = two * (x * z - w * y);
    result[1] = two * (y * z + w * x);
    result[2] = w * w - x * x - y * y + z * z;
}

void attitude_moved_f32(const unit_quaternion_f32_t *attitude, const quaternion_f32_t *change,
    unit_quaternion_f32_t *BESSEMER_RESTRICT unit_quaternion)
{
    const quaternion_f32_t moved_a = {
        .i = attitude->i,
        .j = attitude->j,
        .k = attitude->k,
        .w = attitude->w
    };
    quaternion_f32_t moved;
    quaternion_sum_f32(&moved_a, change, &moved);
    if (isfinite(quaternion_norm_squared_f32(&moved)) != 0) {
        unit_quaternion_new_normalize_f32(&moved, unit_quaternion);
    } else {
        *unit_quaternion = *attitude;
    }
}

void attitude_moved_f64(const unit_quaternion_f64_t *attitude, const quaternion_f64_t *change,
    unit_quaternion_f64_t *BESSEMER_RESTRICT unit_quaternion)
{
    const quaternion_f64_t moved_a = {
        .i = attitude->i,
        .j = attitude->j,
        .k = attitude->k,
        .w = attitude->w
    };
    quaternion_f64_t moved;
    quaternion_sum_f64(&moved_a, change, &moved);
    if (isfinite(quaternion_norm_squared_f64(&moved)) != 0) {
        unit_quaternion_new_normalize_f64(&moved, unit_quaternion);
    } else {
        *unit_quaternion = *attitude;
    }
}

void attitude_gradient_f64(const unit_quaternion_f64_t *attitude, const double measured[3],
    quaternion_f64_t *BESSEMER_RESTRICT quaternion)
{
    const double w = attitude->w;
    const double x = attitude->i;
    const double y = attitude->j;
    const double z = attitude->k;
    const double two = 2.0;
    const double four = 4.0;
    double f_up_f64[3];
    attitude_up_f64(attitude, f_up_f64);
    const double f[3] = {
        f_up_f64[0] - measured[0],
        f_up_f64[1] - measured[1],
        f_up_f64[2] - measured[2]
    };
    quaternion->i = two * (z * f[0] + w * f[1]) - four * x * f[2];
    quaternion->j = two * (z * f[1] - w * f[0]) - four * y * f[2];
    quaternion->k = two * (x * f[0] + y * f[1]);
    quaternion->w = two * (x * f[1] - y * f[0]);
}

/* attitude.h */

/** Gains of `attitude_torque`, and the body's inertia. */
typedef struct {
    /** Torque for an error, 0 or more, N·m/rad. */
    float stiffness[3];
    /** Torque for an error of the rates, 0 or more, N·m·s/rad. */
    float damping[3];
    /**
     * Inertia of the body about its centre of mass, kg·m².
     * A matrix by columns: [row + 3 * column].
     */
    float inertia[9];
} attitude_gains_f32_t;

/** Gains of a `Mahony` filter. */
typedef struct {
    /** Rate at which the attitude follows the accelerometer, about 1, 0 or more. Unit: 1/s. */
    float proportional;
    /** Rate of the bias, about 0.1, 0 or more. Unit: 1/s². */
    float integral;
    /** Period, above 0. Unit: s. */
    float period;
} mahony_gains_f32_t;

/** Gains of a `Mahony` filter. */
typedef struct {
    /** Rate at which the attitude follows the accelerometer, about 1, 0 or more. Unit: 1/s. */
    double proportional;
    /** Rate of the bias, about 0.1, 0 or more. Unit: 1/s². */
    double integral;
    /** Period, above 0. Unit: s. */
    double period;
} mahony_gains_f64_t;

/** Gain of a `Madgwick` filter. */
typedef struct {
    /** Rate β of the correction, about 0.03 to 0.1, 0 or more. Unit: rad/s. */
    double gain;
    /** Period, above 0. Unit: s. */
    double period;
} madgwick_gain_f64_t;

/* madgwick_f64.c */

void madgwick_f64_init(madgwick_f64_t *self)
{
    self->attitude.i = 0.0;
    self->attitude.j = 0.0;
    self->attitude.k = 0.0;
    self->attitude.w = 1.0;
}

void madgwick_f64_step(madgwick_f64_t *BESSEMER_RESTRICT self, const madgwick_gain_f64_t *gain,
    const double rates[3], const double force[3],
    unit_quaternion_f64_t *BESSEMER_RESTRICT unit_quaternion)
{
    const double half_product = 0.5 * gain->period;
    const double half[3] = {
        rates[0] * half_product,
        rates[1] * half_product,
        rates[2] * half_product
    };
    const quaternion_f64_t change_a = {
        .i = self->attitude.i,
        .j = self->attitude.j,
        .k = self->attitude.k,
        .w = self->attitude.w
    };
    quaternion_f64_t change_b;
    quaternion_from_imag_f64(half, &change_b);
    quaternion_f64_t change;
    quaternion_product_f64(&change_a, &change_b, &change);
    const double length = sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    if (length > 0.0 && isfinite(length) != 0) {
        const double downhill_measured[3] = {
            force[0] / length,
            force[1] / length,
            force[2] / length
        };
        quaternion_f64_t downhill;
        attitude_gradient_f64(&self->attitude, downhill_measured, &downhill);
        const double steepness = quaternion_norm_f64(&downhill);
        if (steepness > 0.0) {
            quaternion_f64_t change_b_2;
            quaternion_scaled_f64(&downhill, gain->gain * gain->period / steepness, &change_b_2);
            quaternion_f64_t change_next;
            quaternion_difference_f64(&change, &change_b_2, &change_next);
            change = change_next;
        }
    }
    unit_quaternion_f64_t attitude_next;
    attitude_moved_f64(&self->attitude, &change, &attitude_next);
    self->attitude = attitude_next;
    *unit_quaternion = self->attitude;
}

void madgwick_f64_up(const madgwick_f64_t *self, double result[BESSEMER_RESTRICT 3])
{
    attitude_up_f64(&self->attitude, result);
}

/* madgwick_f64.h */

/**
 * Madgwick's attitude filter: gyroscope and accelerometer, by a step of gradient descent in each period.
 *
 * q += h (½ q ⊗ ω − β ∇f/|∇f|), of length 1 again, for f = |v − a|²/2 with the measured direction of up a and the
 * estimated one v. A force of 0 or a gradient of 0 gives no correction; samples that are not finite are ignored.
 * Initialisation: `Default` is level. Source: Madgwick, Harrison and Vaidyanathan, *Estimation of IMU and MARG
 * Orientation Using a Gradient Descent Algorithm*, ICORR 2011.
 *
 * ```
 * use bessemer_blocks::{Madgwick, MadgwickGain};
 * use bessemer::nalgebra::Vector3;
 *
 * let gain = MadgwickGain { gain: 0.1, period: 0.01_f64 };
 * let mut filter = Madgwick::default();
 * for _ in 0..2000 {
 *    filter.step(&gain, &Vector3::zeros(), &Vector3::new(0.0, 0.6, 0.8));
 * }
 * assert!((filter.up().y - 0.6).abs() < 2e-3);
 * ```
 */
typedef struct {
    /** The attitude. */
    unit_quaternion_f64_t attitude;
} madgwick_f64_t;

/* mahony_f32.c */

void mahony_f32_init(mahony_f32_t *self)
{
    self->attitude.i = 0.0F;
    self->attitude.j = 0.0F;
    self->attitude.k = 0.0F;
    self->attitude.w = 1.0F;
    self->bias[0] = 0.0F;
    self->bias[1] = 0.0F;
    self->bias[2] = 0.0F;
}

void mahony_f32_step(mahony_f32_t *BESSEMER_RESTRICT self, const mahony_gains_f32_t *gains,
    const float rates[3], const float force[3],
    unit_quaternion_f32_t *BESSEMER_RESTRICT unit_quaternion)
{
    const float length = sqrtf(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    float error[3];
    if (length > 0.0F && isfinite(length) != 0) {
        const float error_scaled[3] = {force[0] / length, force[1] / length, force[2] / length};
        float error_up_f32[3];
        attitude_up_f32(&self->attitude, error_up_f32);
        error[0] = error_scaled[1] * error_up_f32[2] - error_scaled[2] * error_up_f32[1];
        error[1] = error_scaled[2] * error_up_f32[0] - error_scaled[0] * error_up_f32[2];
        error[2] = error_scaled[0] * error_up_f32[1] - error_scaled[1] * error_up_f32[0];
    } else {
        error[0] = 0.0F;
        error[1] = 0.0F;
        error[2] = 0.0F;
    }
    const float bias_product = gains->integral * gains->period;
    const float bias[3] = {
        self->bias[0] - error[0] * bias_product,
        self->bias[1] - error[1] * bias_product,
        self->bias[2] - error[2] * bias_product
    };
    const float rates_2[3] = {
        rates[0] - bias[0] + error[0] * gains->proportional,
        rates[1] - bias[1] + error[1] * gains->proportional,
        rates[2] - bias[2] + error[2] * gains->proportional
    };
    if (isfinite(rates_2[0] * rates_2[0] + rates_2[1] * rates_2[1] + rates_2[2] * rates_2[2])
            != 0) {
        self->bias[0] = bias[0];
        self->bias[1] = bias[1];
        self->bias[2] = bias[2];
        const float half_product = 0.5F * gains->period;
        const float half[3] = {
            rates_2[0] * half_product,
            rates_2[1] * half_product,
            rates_2[2] * half_product
        };
        const quaternion_f32_t change_a = {
            .i = self->attitude.i,
            .j = self->attitude.j,
            .k = self->attitude.k,
            .w = self->attitude.w
        };
        quaternion_f32_t change_b;
        quaternion_from_imag_f32(half, &change_b);
        quaternion_f32_t change;
        quaternion_product_f32(&change_a, &change_b, &change);
        unit_quaternion_f32_t attitude_next;
        attitude_moved_f32(&self->attitude, &change, &attitude_next);
        self->attitude = attitude_next;
    }
    *unit_quaternion = self->attitude;
}

void mahony_f32_up(const mahony_f32_t *self, float result[BESSEMER_RESTRICT 3])
{
    attitude_up_f32(&self->attitude, result);
}

/* mahony_f32.h */

/**
 * Mahony's attitude filter: gyroscope and accelerometer, with an estimate of the gyroscope's bias.
 *
 * With the measured direction of up a, the estimated one v and e = a × v: bias −= h ki e, and
 * q += h/2 q ⊗ (ω − bias + kp e), of length 1 again. A force of 0 gives e = 0; samples that are not finite are ignored.
 * Initialisation: `Default` is level, without bias. Source: Mahony, Hamel and Pflimlin, *Nonlinear Complementary
 * Filters on the Special Orthogonal Group*, IEEE Transactions on Automatic Control 53 (5), 2008, equation (48).
 *
 * ```
 * use bessemer_blocks::{Mahony, MahonyGains};
 * use bessemer::nalgebra::Vector3;
 *
 * let gains = MahonyGains { proportional: 2.0, integral: 0.0, period: 0.01_f64 };
 * let mut filter = Mahony::default();
 * let tilted = Vector3::new(0.0, 0.6, 0.8);
 * for _ in 0..2000 {
 *    filter.step(&gains, &Vector3::zeros(), &tilted);
 * }
 * assert!((filter.up() - tilted).norm() < 1e-6);
 * ```
 */
typedef struct {
    /** The attitude. */
    unit_quaternion_f32_t attitude;
    /** Bias of the gyroscope. Unit: rad/s. */
    float bias[3];
} mahony_f32_t;

/* mahony_f64.c */

void mahony_f64_init(mahony_f64_t *self)
{
    self->attitude.i = 0.0;
    self->attitude.j = 0.0;
    self->attitude.k = 0.0;
    self->attitude.w = 1.0;
    self->bias[0] = 0.0;
    self->bias[1] = 0.0;
    self->bias[2] = 0.0;
}

void mahony_f64_step(mahony_f64_t *BESSEMER_RESTRICT self, const mahony_gains_f64_t *gains,
    const double rates[3], const double force[3],
    unit_quaternion_f64_t *BESSEMER_RESTRICT unit_quaternion)
{
    const double length = sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    double error[3];
    if (length > 0.0 && isfinite(length) != 0) {
        const double error_scaled[3] = {force[0] / length, force[1] / length, force[2] / length};
        double error_up_f64[3];
        attitude_up_f64(&self->attitude, error_up_f64);
        error[0] = error_scaled[1] * error_up_f64[2] - error_scaled[2] * error_up_f64[1];
        error[1] = error_scaled[2] * error_up_f64[0] - error_scaled[0] * error_up_f64[2];
        error[2] = error_scaled[0] * error_up_f64[1] - error_scaled[1] * error_up_f64[0];
    } else {
        error[0] = 0.0;
        error[1] = 0.0;
        error[2] = 0.0;
    }
    const double bias_product = gains->integral * gains->period;
    const double bias[3] = {
        self->bias[0] - error[0] * bias_product,
        self->bias[1] - error[1] * bias_product,
        self->bias[2] - error[2] * bias_product
    };
    const double rates_2[3] = {
        rates[0] - bias[0] + error[0] * gains->proportional,
        rates[1] - bias[1] + error[1] * gains->proportional,
        rates[2] - bias[2] + error[2] * gains->proportional
    };
    if (isfinite(rates_2[0] * rates_2[0] + rates_2[1] * rates_2[1] + rates_2[2] * rates_2[2])
            != 0) {
        self->bias[0] = bias[0];
        self->bias[1] = bias[1];
        self->bias[2] = bias[2];
        const double half_product = 0.5 * gains->period;
        const double half[3] = {
            rates_2[0] * half_product,
            rates_2[1] * half_product,
            rates_2[2] * half_product
        };
        const quaternion_f64_t change_a = {
            .i = self->attitude.i,
            .j = self->attitude.j,
            .k = self->attitude.k,
            .w = self->attitude.w
        };
        quaternion_f64_t change_b;
        quaternion_from_imag_f64(half, &change_b);
        quaternion_f64_t change;
        quaternion_product_f64(&change_a, &change_b, &change);
        unit_quaternion_f64_t attitude_next;
        attitude_moved_f64(&self->attitude, &change, &attitude_next);
        self->attitude = attitude_next;
    }
    *unit_quaternion = self->attitude;
}

/* mahony_f64.h */

/**
 * Mahony's attitude filter: gyroscope and accelerometer, with an estimate of the gyroscope's bias.
 *
 * With the measured direction of up a, the estimated one v and e = a × v: bias −= h ki e, and
 * q += h/2 q ⊗ (ω − bias + kp e), of length 1 again. A force of 0 gives e = 0; samples that are not finite are ignored.
 * Initialisation: `Default` is level, without bias. Source: Mahony, Hamel and Pflimlin, *Nonlinear Complementary
 * Filters on the Special Orthogonal Group*, IEEE Transactions on Automatic Control 53 (5), 2008, equation (48).
 *
 * ```
 * use bessemer_blocks::{Mahony, MahonyGains};
 * use bessemer::nalgebra::Vector3;
 *
 * let gains = MahonyGains { proportional: 2.0, integral: 0.0, period: 0.01_f64 };
 * let mut filter = Mahony::default();
 * let tilted = Vector3::new(0.0, 0.6, 0.8);
 * for _ in 0..2000 {
 *    filter.step(&gains, &Vector3::zeros(), &tilted);
 * }
 * assert!((filter.up() - tilted).norm() < 1e-6);
 * ```
 */
typedef struct {
    /** The attitude. */
    unit_quaternion_f64_t attitude;
    /** Bias of the gyroscope. Unit: rad/s. */
    double bias[3];
} mahony_f64_t;
