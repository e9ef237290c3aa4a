/* The C of tests/corpus/src/programs/matrices/turned_by_type.rs. Written by a test. */

/* turned_by_type.c */

void rotation2_new(int32_t steps, rotation2_t *rotation2)
{
    rotation2->steps = steps & 0xFFF;
}

void rotation2_from_euler_angles(int16_t degrees, rotation2_t *rotation2)
{
    rotation2_new((int32_t)degrees * 512 / 45, rotation2);
}

bessemer_status_t rotation2_rotation_between(const rotation2_t *self, const rotation2_t *other,
    rotation2_t *BESSEMER_RESTRICT rotation2)
{
    if ((int64_t)other->steps - (int64_t)self->steps < INT32_MIN
            || (int64_t)other->steps - (int64_t)self->steps > INT32_MAX) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    rotation2_new(other->steps - self->steps, rotation2);
    return BESSEMER_STATUS_OK;
}

bessemer_status_t turned_by_type_own(int16_t degrees, int32_t steps, rotation2_t *rotation2)
{
    bessemer_status_t status;
    rotation2_t turned;
    rotation2_from_euler_angles(degrees, &turned);
    rotation2_t rotation2_other;
    rotation2_new(steps, &rotation2_other);
    status = rotation2_rotation_between(&turned, &rotation2_other, rotation2);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    return BESSEMER_STATUS_OK;
}

void turned_by_type_renamed(double roll, double pitch, double yaw,
    unit_quaternion_f64_t *unit_quaternion)
{
    rotation_from_euler_angles_f64(roll, pitch, yaw, unit_quaternion);
}

void turned_by_type_in_space(const double a[3], const double b[3],
    double result[BESSEMER_RESTRICT 9])
{
    double first[9];
    rotation_matrix_from_scaled_axis_f64(a, first);
    double second[9];
    rotation_matrix_from_scaled_axis_f64(b, second);
    product_f64_3x3_3x3(first, second, result);
}

void turned_by_type_in_the_plane(float angle, float result[4])
{
    rotation_matrix_from_angle_f32(angle, result);
}

/* turned_by_type.h */

/** A rotation in the plane, counted by an encoder. */
typedef struct {
    /** Steps of 1/4096 of a turn. */
    int32_t steps;
} rotation2_t;
