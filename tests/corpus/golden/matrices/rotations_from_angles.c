/* The C of tests/corpus/src/programs/matrices/rotations_from_angles.rs. Written by a test. */

/* gyro.c */

void gyro_init(gyro_t *self)
{
    self->attitude.i = 0.0;
    self->attitude.j = 0.0;
    self->attitude.k = 0.0;
    self->attitude.w = 1.0;
}

void gyro_step(gyro_t *BESSEMER_RESTRICT self, const double rates[3], double period,
    double result[BESSEMER_RESTRICT 3])
{
    const double attitude_axis[3] = {rates[0] * period, rates[1] * period, rates[2] * period};
    unit_quaternion_f64_t attitude_second;
    rotation_from_scaled_axis_f64(attitude_axis, &attitude_second);
    unit_quaternion_f64_t attitude_next;
    unit_quaternion_product_f64(&self->attitude, &attitude_second, &attitude_next);
    self->attitude = attitude_next;
    unit_quaternion_renormalize_fast_f64(&self->attitude);
    triple_f64_f64_f64_t pair;
    rotation_euler_angles_f64(&self->attitude, &pair);
    result[0] = pair.first;
    result[1] = pair.second;
    result[2] = pair.third;
}

/* gyro.h */

/** Integrates the rates of a gyroscope to an orientation. */
typedef struct {
    /** Rotation from the body's frame to the world's. */
    unit_quaternion_f64_t attitude;
} gyro_t;

/* rotations_from_angles.c */

void rotations_from_angles_in_vehicle(double roll, double pitch, double yaw,
    const double reading[3], double result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f64_t result_q;
    rotation_from_euler_angles_f64(roll, pitch, yaw, &result_q);
    unit_quaternion_transform_vector_f64(&result_q, reading, result);
}

void rotations_from_angles_middle(const unit_quaternion_f32_t *one,
    const unit_quaternion_f32_t *other, pair_unit_quaternion_f32_f32_t *BESSEMER_RESTRICT result)
{
    rotation_slerp_f32(one, other, 0.5F, &result->first);
    result->second = rotation_angle_to_f32(one, other);
}

void rotations_from_angles_seen(const double axis[3], double angle, const double point[3],
    double result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f64_t result_q;
    rotation_from_axis_angle_f64(axis, angle, &result_q);
    unit_quaternion_inverse_transform_vector_f64(&result_q, point, result);
}

void rotations_from_angles_part(const unit_quaternion_f64_t *whole, double share,
    double result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f64_t result_q;
    rotation_powf_f64(whole, share, &result_q);
    rotation_scaled_axis_f64(&result_q, result);
}

void rotations_from_angles_about(const unit_quaternion_f32_t *q,
    option_pair_vector3_f32_f32_t *BESSEMER_RESTRICT result)
{
    rotation_axis_angle_f32(q, result);
}

void rotations_from_angles_there_and_back(double roll, double pitch, double yaw,
    triple_f64_f64_f64_t *result)
{
    double result_m[9];
    rotation_matrix_from_euler_angles_f64(roll, pitch, yaw, result_m);
    rotation_matrix_euler_angles_f64(result_m, result);
}

void rotations_from_angles_matrices(const double axis[3], double angle,
    pair_matrix3x3_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    rotation_matrix_from_axis_angle_f64(axis, angle, result->first);
    rotation_matrix_from_angle_f64(angle, result->second);
}
