/* The C of tests/corpus/src/programs/matrices/unit_quaternions.rs. Written by a test. */

/* unit_quaternions.c */

void unit_quaternions_in_world(const attitudes_t *attitudes, const double seen[3],
    double result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f64_t result_q;
    unit_quaternion_product_f64(&attitudes->body, &attitudes->camera, &result_q);
    unit_quaternion_transform_vector_f64(&result_q, seen, result);
}

void unit_quaternions_error(const unit_quaternion_f64_t *wanted, const unit_quaternion_f64_t *is,
    double result[BESSEMER_RESTRICT 3])
{
    unit_quaternion_f64_t error_first;
    unit_quaternion_inverse_f64(is, &error_first);
    unit_quaternion_f64_t error;
    unit_quaternion_product_f64(&error_first, wanted, &error);
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

void unit_quaternions_turned(const unit_quaternion_f32_t *attitude, const float rates[3],
    float period, unit_quaternion_f32_t *BESSEMER_RESTRICT unit_quaternion)
{
    const float unit_quaternion_axis[3] = {rates[0] * period, rates[1] * period, rates[2] * period};
    unit_quaternion_append_axisangle_linearized_f32(attitude, unit_quaternion_axis,
        unit_quaternion);
}

void unit_quaternions_halves(const unit_quaternion_f64_t *one, const unit_quaternion_f64_t *other,
    pair_unit_quaternion_f64_unit_quaternion_f64_t *BESSEMER_RESTRICT result)
{
    unit_quaternion_nlerp_f64(one, other, 0.5, &result->first);
    unit_quaternion_rotation_to_f64(&result->first, other, &result->second);
}

void unit_quaternions_same(const attitudes_t *one, const attitudes_t *other,
    pair_bool_bool_t *BESSEMER_RESTRICT result)
{
    const bool first = attitudes_equal(one, other);
    const quaternion_f64_t quaternion_q = {
        .i = one->body.i,
        .j = one->body.j,
        .k = one->body.k,
        .w = one->body.w
    };
    quaternion_f64_t quaternion;
    quaternion_negative_f64(&quaternion_q, &quaternion);
    const unit_quaternion_f64_t result_other = {
        .i = quaternion.i,
        .j = quaternion.j,
        .k = quaternion.k,
        .w = quaternion.w
    };
    result->first = first;
    result->second = unit_quaternion_f64_equal(&one->body, &result_other);
}

void unit_quaternions_received(double w, double i, double j, double k,
    unit_quaternion_f64_t *unit_quaternion)
{
    const quaternion_f64_t q = {.i = i, .j = j, .k = k, .w = w};
    if (quaternion_norm_squared_f64(&q) > 0.5) {
        unit_quaternion_new_normalize_f64(&q, unit_quaternion);
    } else {
        static const unit_quaternion_f64_t received = {.i = 0.0, .j = 0.0, .k = 0.0, .w = 1.0};
        *unit_quaternion = received;
    }
}

void unit_quaternions_there_and_back(const unit_quaternion_f64_t *q,
    unit_quaternion_f64_t *BESSEMER_RESTRICT unit_quaternion)
{
    double unit_quaternion_m[9];
    unit_quaternion_to_rotation_matrix_f64(q, unit_quaternion_m);
    unit_quaternion_from_rotation_matrix_f64(unit_quaternion_m, unit_quaternion);
}

void unit_quaternions_mixed(const unit_quaternion_f64_t *q, const double m[9],
    unit_quaternion_f64_t *BESSEMER_RESTRICT unit_quaternion)
{
    unit_quaternion_f64_t unit_quaternion_first;
    unit_quaternion_product_with_matrix_f64(q, m, &unit_quaternion_first);
    unit_quaternion_f64_t unit_quaternion_first_2;
    unit_quaternion_quotient_f64(&unit_quaternion_first, q, &unit_quaternion_first_2);
    unit_quaternion_f64_t unit_quaternion_second;
    unit_quaternion_quotient_of_matrix_f64(m, q, &unit_quaternion_second);
    unit_quaternion_f64_t unit_quaternion_q;
    unit_quaternion_product_f64(&unit_quaternion_first_2, &unit_quaternion_second,
        &unit_quaternion_q);
    unit_quaternion_quotient_by_matrix_f64(&unit_quaternion_q, m, unit_quaternion);
}

float unit_quaternions_parts(const unit_quaternion_f32_t *q)
{
    const quaternion_f32_t quaternion = {.i = q->i, .j = q->j, .k = q->k, .w = q->w};
    const float vector[4] = {q->i, q->j, q->k, q->w};
    const quaternion_f32_t quaternion_2 = {.i = q->i, .j = q->j, .k = q->k, .w = q->w};
    const float vector_2[4] = {quaternion_2.i, quaternion_2.j, quaternion_2.k, quaternion_2.w};
    const float result_vector[4] = {q->i, q->j, q->k, q->w};
    const quaternion_f32_t result_b = {.i = q->i, .j = q->j, .k = q->k, .w = q->w};
    const quaternion_f32_t result_q = {.i = q->i, .j = q->j, .k = q->k, .w = q->w};
    return quaternion.w + vector[1] * vector_2[1]
        + sqrtf(result_vector[0] * result_vector[0] + result_vector[2] * result_vector[2]
        + (result_vector[1] * result_vector[1] + result_vector[3] * result_vector[3]))
        + quaternion_dot_f32(&quaternion, &result_b) + quaternion_norm_f32(&result_q);
}

void unit_quaternions_points(const unit_quaternion_f64_t *q, const double p[3], const double d[3],
    triple_vector3_f64_vector3_f64_matrix4x4_f64_t *BESSEMER_RESTRICT result)
{
    double there[3];
    unit_quaternion_transform_vector_f64(q, p, there);
    const double back_vector[3] = {there[0] + d[0], there[1] + d[1], there[2] + d[2]};
    unit_quaternion_inverse_transform_vector_f64(q, back_vector, result->first);
    unit_quaternion_transform_vector_f64(q, d, result->second);
    unit_quaternion_to_homogeneous_f64(q, result->third);
}

void unit_quaternions_all(const unit_quaternion_f64_t joints[4],
    unit_quaternion_f64_t *BESSEMER_RESTRICT unit_quaternion)
{
    unit_quaternion_f64_t whole = {.i = 0.0, .j = 0.0, .k = 0.0, .w = 1.0};
    for (uint32_t i = 0U; i < 4U; i++) {
        unit_quaternion_f64_t whole_next;
        unit_quaternion_product_f64(&whole, &joints[i], &whole_next);
        whole = whole_next;
    }
    (void)unit_quaternion_renormalize_f64(&whole);
    unit_quaternion_inverse_mut_f64(&whole);
    unit_quaternion_quotient_f64(&whole, &joints[0], unit_quaternion);
}

void unit_quaternions_axis(const unit_quaternion_f64_t *q, double result[BESSEMER_RESTRICT 3])
{
    option_vector3_f64_t axis;
    unit_quaternion_axis_f64(q, &axis);
    if (axis.is_some) {
        result[0] = axis.value[0];
        result[1] = axis.value[1];
        result[2] = axis.value[2];
    } else {
        result[0] = 0.0;
        result[1] = 0.0;
        result[2] = 0.0;
    }
}

/* unit_quaternions.h */

/** A vehicle's attitude, and the attitude of its camera. */
typedef struct {
    /** Rotation from the body's frame to the world's. */
    unit_quaternion_f64_t body;
    /** Rotation from the camera's frame to the body's. */
    unit_quaternion_f64_t camera;
} attitudes_t;
