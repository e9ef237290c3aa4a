/* The C of tests/corpus/src/programs/blocks/navigating.rs. Written by a test. */

/* navigating.c */

void navigating_seen(const geodetic_f64_t *origin, const geodetic_f64_t *position,
    double result[BESSEMER_RESTRICT 3])
{
    double result_point[3];
    frames_ecef_from_geodetic_f64(position, result_point);
    double result_vector[3];
    frames_enu_from_ecef_f64(origin, result_point, result_vector);
    frames_ned_from_enu_f64(result_vector, result);
}

void navigating_reached(const geodetic_f64_t *origin, const double offset[3],
    geodetic_f64_t *BESSEMER_RESTRICT geodetic)
{
    double geodetic_point[3];
    frames_ned_from_enu_f64(offset, geodetic_point);
    double geodetic_position[3];
    frames_ecef_from_enu_f64(origin, geodetic_point, geodetic_position);
    frames_geodetic_from_ecef_f64(geodetic_position, geodetic);
}

void navigating_vertical(const geodetic_f32_t *origin, float result[BESSEMER_RESTRICT 3])
{
    float result_enu_rotation_f32[9];
    frames_enu_rotation_f32(origin, result_enu_rotation_f32);
    const float result_vector[3] = {0.0F, 0.0F, 1.0F};
    result[0] = result_enu_rotation_f32[0 + 3 * 0] * result_vector[0]
        + result_enu_rotation_f32[1 + 3 * 0] * result_vector[1]
        + result_enu_rotation_f32[2 + 3 * 0] * result_vector[2];
    result[1] = result_enu_rotation_f32[0 + 3 * 1] * result_vector[0]
        + result_enu_rotation_f32[1 + 3 * 1] * result_vector[1]
        + result_enu_rotation_f32[2 + 3 * 1] * result_vector[2];
    result[2] = result_enu_rotation_f32[0 + 3 * 2] * result_vector[0]
        + result_enu_rotation_f32[1 + 3 * 2] * result_vector[1]
        + result_enu_rotation_f32[2 + 3 * 2] * result_vector[2];
}
