/* The C of tests/corpus/src/programs/matrices/poses.rs. Written by a test. */

/* arm.c */

void arm_init(arm_t *self)
{
    for (uint32_t i = 0U; i < 3U; i++) {
        self->joints[i].rotation.i = 0.0;
        self->joints[i].rotation.j = 0.0;
        self->joints[i].rotation.k = 0.0;
        self->joints[i].rotation.w = 1.0;
        self->joints[i].translation[0] = 0.0;
        self->joints[i].translation[1] = 0.0;
        self->joints[i].translation[2] = 0.0;
    }

    /* In Rust: `Isometry3::translation(0.5, 0.0, 1.0)`. */
    self->tool.rotation.i = 0.0;
    self->tool.rotation.j = 0.0;
    self->tool.rotation.k = 0.0;
    self->tool.rotation.w = 1.0;
    self->tool.translation[0] = 0.5;
    self->tool.translation[1] = 0.0;
    self->tool.translation[2] = 1.0;
}

void arm_turn(arm_t *BESSEMER_RESTRICT self, uint8_t at, const unit_quaternion_f64_t *by,
    double result[BESSEMER_RESTRICT 3])
{
    const uint32_t at_2 = (uint32_t)(uint8_t)(at % 3U);
    isometry3_f64_t joints_next;
    isometry_product_with_rotation_f64(&self->joints[at_2], by, &joints_next);
    self->joints[at_2] = joints_next;
    isometry3_f64_t tool_first;
    isometry_product_f64(&self->joints[0], &self->joints[1], &tool_first);
    isometry_product_f64(&tool_first, &self->joints[2], &self->tool);
    const double result_point[3] = {0.0, 0.0, 0.1};
    isometry_transform_point_f64(&self->tool, result_point, result);
}

/* arm.h */

/** The arm of a robot; each joint is mounted on the one before. */
typedef struct {
    /** Pose of each joint relative to the one before. */
    isometry3_f64_t joints[3];
    /** Pose of the tool relative to the base. */
    isometry3_f64_t tool;
} arm_t;

/* poses.c */

void poses_seen(const isometry3_f64_t *camera, const double point[3],
    pair_vector3_f64_vector3_f64_t *BESSEMER_RESTRICT result)
{
    isometry3_f64_t back;
    isometry_inverse_f64(camera, &back);
    isometry_transform_point_f64(&back, point, result->first);
    const double result_vector[3] = {0.0, 0.0, 1.0};
    isometry_transform_vector_f64(camera, result_vector, result->second);
}

void poses_relative(const isometry3_f64_t *one, const isometry3_f64_t *other,
    isometry3_f64_t result[BESSEMER_RESTRICT 3])
{
    isometry3_f64_t result_inv_mul_f64;
    isometry_inv_mul_f64(one, other, &result_inv_mul_f64);
    isometry3_f64_t result_first;
    isometry_inverse_f64(one, &result_first);
    isometry3_f64_t result_product_f64;
    isometry_product_f64(&result_first, other, &result_product_f64);
    isometry3_f64_t result_quotient_f64;
    isometry_quotient_f64(other, one, &result_quotient_f64);
    result[0] = result_inv_mul_f64;
    result[1] = result_product_f64;
    result[2] = result_quotient_f64;
}

void poses_with_parts(const float by[3], const unit_quaternion_f32_t *q,
    isometry3_f32_t *BESSEMER_RESTRICT isometry3)
{
    const isometry3_f32_t pose = {.rotation = *q, .translation = {by[0], by[1], by[2]}};
    isometry3_f32_t turned_pose;
    isometry_product_of_rotation_f32(q, &pose, &turned_pose);
    unit_quaternion_f32_t turned_q;
    unit_quaternion_inverse_f32(q, &turned_q);
    isometry3_f32_t turned_pose_2;
    isometry_product_with_rotation_f32(&turned_pose, &turned_q, &turned_pose_2);
    isometry3_f32_t turned;
    isometry_quotient_by_rotation_f32(&turned_pose_2, q, &turned);
    isometry3_f32_t moved_pose;
    isometry_product_of_translation_f32(by, &turned, &moved_pose);
    const float moved_by[3] = {-by[0], -by[1], -by[2]};
    isometry3_f32_t moved;
    isometry_product_with_translation_f32(&moved_pose, moved_by, &moved);
    isometry3_f32_t all_first;
    isometry_translated_rotation_f32(by, q, &all_first);
    isometry3_f32_t all_second;
    isometry_rotated_translation_f32(q, by, &all_second);
    isometry3_f32_t all_first_2;
    isometry_product_f32(&all_first, &all_second, &all_first_2);
    isometry3_f32_t all;
    isometry_product_f32(&all_first_2, &moved, &all);
    isometry3_f32_t all_next;
    isometry_product_f32(&all, &pose, &all_next);
    all = all_next;
    all.translation[0] += 1.0F;
    isometry_append_translation_mut_f32(&all, by);
    isometry_append_rotation_mut_f32(&all, q);
    isometry_quotient_of_rotation_f32(q, &all, isometry3);
}

void poses_there_and_back(const isometry3_f64_t *pose, const double p[3], const double v[3],
    pair_vector3_f64_vector3_f64_t *BESSEMER_RESTRICT result)
{
    double there_transform_point_f64[3];
    isometry_transform_point_f64(pose, p, there_transform_point_f64);
    double there_transform_vector_f64[3];
    isometry_transform_vector_f64(pose, v, there_transform_vector_f64);
    const double there[3] = {
        there_transform_point_f64[0] + there_transform_vector_f64[0],
        there_transform_point_f64[1] + there_transform_vector_f64[1],
        there_transform_point_f64[2] + there_transform_vector_f64[2]
    };
    isometry_inverse_transform_point_f64(pose, there, result->first);
    isometry_inverse_transform_vector_f64(pose, v, result->second);
}

void poses_matrix(const isometry3_f64_t *pose, double result[BESSEMER_RESTRICT 16])
{
    isometry_to_homogeneous_f64(pose, result);
}

void poses_apart(const isometry3_f64_t *one, const isometry3_f64_t *other,
    pair_bool_f64_t *BESSEMER_RESTRICT result)
{
    const double result_difference[3] = {
        one->translation[0] - other->translation[0],
        one->translation[1] - other->translation[1],
        one->translation[2] - other->translation[2]
    };
    result->first = isometry3_f64_equal(one, other);
    result->second = sqrt(result_difference[0] * result_difference[0]
        + result_difference[1] * result_difference[1]
        + result_difference[2] * result_difference[2]);
}
