/* The C of tests/corpus/src/programs/matrices/quaternions.rs. Written by a test. */

/* quaternions.c */

static const quaternion_f64_t QUATERNION_DEFAULT = {.i = 0.0, .j = 0.0, .k = 0.0, .w = 0.0};

void quaternions_rate(const quaternion_f64_t *q, const double rates[3],
    quaternion_f64_t *BESSEMER_RESTRICT quaternion)
{
    quaternion_f64_t quaternion_b;
    quaternion_from_imag_f64(rates, &quaternion_b);
    quaternion_f64_t quaternion_q;
    quaternion_product_f64(q, &quaternion_b, &quaternion_q);
    quaternion_scaled_f64(&quaternion_q, 0.5, quaternion);
}

void quaternions_step(const quaternion_f64_t *q, const double rates[3], double period,
    quaternion_f64_t *BESSEMER_RESTRICT quaternion)
{
    quaternion_f64_t first;
    quaternions_rate(q, rates, &first);
    quaternion_f64_t second_b;
    quaternion_scaled_f64(&first, 0.5 * period, &second_b);
    quaternion_f64_t second_q;
    quaternion_sum_f64(q, &second_b, &second_q);
    quaternion_f64_t second;
    quaternions_rate(&second_q, rates, &second);
    quaternion_f64_t quaternion_b;
    quaternion_scaled_f64(&second, period, &quaternion_b);
    quaternion_f64_t quaternion_q;
    quaternion_sum_f64(q, &quaternion_b, &quaternion_q);
    quaternion_normalize_f64(&quaternion_q, quaternion);
}

void quaternions_operators(const quaternion_f64_t *a, const quaternion_f64_t *b, double factor,
    quaternion_f64_t *BESSEMER_RESTRICT quaternion)
{
    quaternion_f64_t c_a;
    quaternion_negative_f64(a, &c_a);
    quaternion_f64_t c_a_2;
    quaternion_product_f64(&c_a, b, &c_a_2);
    quaternion_f64_t c_b;
    quaternion_unscaled_f64(a, factor, &c_b);
    quaternion_f64_t c_a_3;
    quaternion_difference_f64(&c_a_2, &c_b, &c_a_3);
    quaternion_f64_t c_b_2;
    quaternion_scaled_by_f64(factor, b, &c_b_2);
    quaternion_f64_t c;
    quaternion_sum_f64(&c_a_3, &c_b_2, &c);
    quaternion_f64_t c_next;
    quaternion_sum_f64(&c, a, &c_next);
    c = c_next;
    quaternion_f64_t c_next_2;
    quaternion_difference_f64(&c, b, &c_next_2);
    c = c_next_2;
    quaternion_f64_t c_next_3;
    quaternion_product_f64(&c, b, &c_next_3);
    c = c_next_3;
    quaternion_f64_t c_next_4;
    quaternion_scaled_f64(&c, factor, &c_next_4);
    c = c_next_4;
    quaternion_f64_t c_next_5;
    quaternion_unscaled_f64(&c, 3.0, &c_next_5);
    c = c_next_5;
    c.w += 1.0;
    quaternion_conjugate_mut_f64(&c);
    quaternion_scaled_by_f64(2.0, &c, quaternion);
}

void quaternions_measures(const quaternion_f32_t *a, const quaternion_f32_t *b,
    float result[BESSEMER_RESTRICT 4])
{
    quaternion_f32_t result_q;
    quaternion_lerp_f32(a, b, 0.25F, &result_q);
    quaternion_f32_t result_q_2;
    quaternion_squared_f32(&result_q, &result_q_2);
    result[0] = quaternion_norm_f32(a);
    result[1] = quaternion_norm_squared_f32(a);
    result[2] = quaternion_dot_f32(a, b);
    result[3] = quaternion_scalar_f32(&result_q_2);
}

void quaternions_inverse(const quaternion_f64_t *q,
    option_quaternion_f64_t *BESSEMER_RESTRICT result)
{
    quaternion_try_inverse_f64(q, result);
}

void quaternions_parts(double scalar, const double vector[3], double result[BESSEMER_RESTRICT 3])
{
    quaternion_f64_t q_value;
    quaternion_from_parts_f64(scalar, vector, &q_value);
    quaternion_f64_t q;
    quaternion_conjugate_f64(&q_value, &q);
    const double length = quaternion_normalize_mut_f64(&q);
    double result_imag_f64[3];
    quaternion_imag_f64(&q, result_imag_f64);
    quaternion_f64_t result_q;
    quaternion_from_real_f64(scalar, &result_q);
    quaternion_f64_t result_q_2;
    quaternion_half_f64(&result_q, &result_q_2);
    double result_imag_f64_2[3];
    quaternion_imag_f64(&result_q_2, result_imag_f64_2);
    result[0] = result_imag_f64[0] * length + result_imag_f64_2[0];
    result[1] = result_imag_f64[1] * length + result_imag_f64_2[1];
    result[2] = result_imag_f64[2] * length + result_imag_f64_2[2];
}

void quaternions_same(const quaternion_f64_t *a, const quaternion_f64_t *b,
    pair_bool_bool_t *BESSEMER_RESTRICT result)
{
    result->first = a->i == b->i && a->j == b->j && a->k == b->k && a->w == b->w;
    result->second = a->i == QUATERNION_DEFAULT.i && a->j == QUATERNION_DEFAULT.j
        && a->k == QUATERNION_DEFAULT.k && a->w == QUATERNION_DEFAULT.w;
}
