/* The C of tests/corpus/src/programs/matrices/turned.rs. Written by a test. */

/* turned.c */

void turned_there_and_back(double roll, double pitch, double yaw, triple_f64_f64_f64_t *result)
{
    unit_quaternion_f64_t q;
    rotation_from_euler_angles_f64(roll, pitch, yaw, &q);
    rotation_euler_angles_f64(&q, result);
}

void turned_by_matrix(float roll, float pitch, float yaw, triple_f32_f32_f32_t *result)
{
    float result_m[9];
    rotation_matrix_from_euler_angles_f32(roll, pitch, yaw, result_m);
    rotation_matrix_euler_angles_f32(result_m, result);
}

void turned_part_of_the_way(const double a[3], const double b[3], double share,
    double result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f64_t from;
    rotation_from_scaled_axis_f64(a, &from);
    unit_quaternion_f64_t to;
    rotation_from_scaled_axis_f64(b, &to);
    unit_quaternion_f64_t result_q;
    rotation_slerp_f64(&from, &to, share, &result_q);
    rotation_scaled_axis_f64(&result_q, result);
}

void turned_between(const double a[3], const double b[3],
    option_pair_vector3_f64_f64_t *BESSEMER_RESTRICT result)
{
    option_pair_vector3_f64_f64_t option;
    norms_try_direction_and_norm_f64_3(a, 1e-6, &option);
    if (!option.is_some) {
        *result = (option_pair_vector3_f64_f64_t){.is_some = false};
        return;
    }
    option_vector3_f64_t to_option;
    norms_try_direction_f64_3(b, 1e-6, &to_option);
    if (!to_option.is_some) {
        *result = (option_pair_vector3_f64_f64_t){.is_some = false};
        return;
    }
    const double to[3] = {to_option.value[0], to_option.value[1], to_option.value[2]};
    option_unit_quaternion_f64_t turn_option;
    rotation_rotation_between_axis_f64(option.value.first, to, &turn_option);
    if (!turn_option.is_some) {
        *result = (option_pair_vector3_f64_f64_t){.is_some = false};
        return;
    }
    const unit_quaternion_f64_t turn = turn_option.value;
    option_pair_vector3_f64_f64_t turn_option_2;
    rotation_axis_angle_f64(&turn, &turn_option_2);
    if (!turn_option_2.is_some) {
        *result = (option_pair_vector3_f64_f64_t){.is_some = false};
        return;
    }
    result->value.first[0] = turn_option_2.value.first[0] * option.value.second;
    result->value.first[1] = turn_option_2.value.first[1] * option.value.second;
    result->value.first[2] = turn_option_2.value.first[2] * option.value.second;
    result->is_some = true;
    result->value.second = turn_option_2.value.second;
}

void turned_share_between(const float a[3], const float b[3], float share,
    option_f32x4_t *BESSEMER_RESTRICT result)
{
    option_unit_quaternion_f32_t whole_option;
    rotation_rotation_between_f32(a, b, &whole_option);
    if (!whole_option.is_some) {
        *result = (option_f32x4_t){.is_some = false};
        return;
    }
    const unit_quaternion_f32_t whole = whole_option.value;
    option_unit_quaternion_f32_t part_option;
    rotation_scaled_rotation_between_f32(a, b, share, &part_option);
    if (!part_option.is_some) {
        *result = (option_f32x4_t){.is_some = false};
        return;
    }
    const unit_quaternion_f32_t part = part_option.value;
    option_vector3_f32_t along_option;
    norms_try_direction_f32_3(b, 1e-6F, &along_option);
    if (!along_option.is_some) {
        *result = (option_f32x4_t){.is_some = false};
        return;
    }
    const float along_option_a[3] = {1.0F, 0.0F, 0.0F};
    option_unit_quaternion_f32_t along_option_2;
    rotation_scaled_rotation_between_axis_f32(along_option_a, along_option.value, share,
        &along_option_2);
    if (!along_option_2.is_some) {
        *result = (option_f32x4_t){.is_some = false};
        return;
    }
    const unit_quaternion_f32_t along = along_option_2.value;
    unit_quaternion_f32_t left_first;
    unit_quaternion_rotation_to_f32(&part, &whole, &left_first);
    unit_quaternion_f32_t left;
    unit_quaternion_product_f32(&left_first, &along, &left);
    result->is_some = true;
    result->value[0] = left.w;
    result->value[1] = left.i;
    result->value[2] = left.j;
    result->value[3] = left.k;
}

void turned_about(const float axis[3], float angle,
    unit_quaternion_f32_t *BESSEMER_RESTRICT unit_quaternion)
{
    rotation_from_axis_angle_f32(axis, angle, unit_quaternion);
}
