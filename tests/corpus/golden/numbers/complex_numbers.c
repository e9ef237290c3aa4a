/* The C of tests/corpus/src/programs/numbers/complex_numbers.rs. Written by a test. */

/* complex_numbers.c */

static const complex_number_f64_t COMPLEX_DEFAULT = {.re = 0.0, .im = 0.0};

void complex_numbers_arithmetic(const complex_number_f64_t *a, const complex_number_f64_t *b,
    complex_number_f64_t *BESSEMER_RESTRICT complex_number)
{
    complex_number_f64_t sum;
    bessemer_complex_sum_f64(a, b, &sum);
    complex_number_f64_t sum_b;
    bessemer_complex_product_f64(a, b, &sum_b);
    complex_number_f64_t sum_next;
    bessemer_complex_difference_f64(&sum, &sum_b, &sum_next);
    sum = sum_next;
    const complex_number_f64_t sum_b_2 = {.re = 0.5, .im = b->im};
    complex_number_f64_t sum_next_2;
    bessemer_complex_product_f64(&sum, &sum_b_2, &sum_next_2);
    sum = sum_next_2;
    complex_number_f64_t sum_next_3;
    bessemer_complex_quotient_f64(&sum, b, &sum_next_3);
    sum = sum_next_3;
    complex_number_f64_t complex_number_z;
    bessemer_complex_quotient_f64(&sum, a, &complex_number_z);
    complex_number_f64_t complex_number_a;
    bessemer_complex_negative_f64(&complex_number_z, &complex_number_a);
    complex_number_f64_t complex_number_b;
    bessemer_complex_i_f64(&complex_number_b);
    bessemer_complex_sum_f64(&complex_number_a, &complex_number_b, complex_number);
}

void complex_numbers_with_reals(const complex_number_f32_t *z, float x,
    complex_number_f32_t result[BESSEMER_RESTRICT 4])
{
    complex_number_f32_t scaled;
    bessemer_complex_scale_f32(z, 2.0F, &scaled);
    complex_number_f32_t scaled_next;
    bessemer_complex_sum_with_real_f32(&scaled, x, &scaled_next);
    scaled = scaled_next;
    complex_number_f32_t scaled_next_2;
    bessemer_complex_scale_f32(&scaled, x, &scaled_next_2);
    scaled = scaled_next_2;
    complex_number_f32_t result_difference_with_real_f32;
    bessemer_complex_difference_with_real_f32(&scaled, 1.0F, &result_difference_with_real_f32);
    complex_number_f32_t result_b;
    bessemer_complex_unscale_f32(z, x, &result_b);
    complex_number_f32_t result_difference_of_real_f32;
    bessemer_complex_difference_of_real_f32(1.0F, &result_b, &result_difference_of_real_f32);
    complex_number_f32_t result_scaled_by_f32;
    bessemer_complex_scaled_by_f32(x, z, &result_scaled_by_f32);
    complex_number_f32_t result_a;
    bessemer_complex_quotient_of_real_f32(x, z, &result_a);
    complex_number_f32_t result_b_2;
    bessemer_complex_from_real_f32(x, &result_b_2);
    complex_number_f32_t result_sum_f32;
    bessemer_complex_sum_f32(&result_a, &result_b_2, &result_sum_f32);
    result[0] = result_difference_with_real_f32;
    result[1] = result_difference_of_real_f32;
    result[2] = result_scaled_by_f32;
    result[3] = result_sum_f32;
}

void complex_numbers_parts(const complex_number_f64_t *z, uint32_t n,
    tuple4_f64_f64_complex_number_f64_bool_t *BESSEMER_RESTRICT result)
{
    complex_number_f64_t turned_a;
    bessemer_complex_conj_f64(z, &turned_a);
    complex_number_f64_t turned_b;
    bessemer_complex_inv_f64(z, &turned_b);
    complex_number_f64_t turned_z;
    bessemer_complex_product_f64(&turned_a, &turned_b, &turned_z);
    complex_number_f64_t turned_z_2;
    bessemer_complex_scale_f64(&turned_z, bessemer_complex_norm_sqr_f64(z), &turned_z_2);
    complex_number_f64_t turned;
    bessemer_complex_unscale_f64(&turned_z_2, 3.0, &turned);
    complex_number_f64_t powers_a;
    bessemer_complex_powu_f64(z, n & 7U, &powers_a);
    complex_number_f64_t powers_b;
    bessemer_complex_powi_f64(z, -3, &powers_b);
    complex_number_f64_t powers;
    bessemer_complex_sum_f64(&powers_a, &powers_b, &powers);
    result->first = turned.re;
    result->second = bessemer_complex_l1_norm_f64(&turned);
    result->third = powers;
    result->fourth = bessemer_complex_is_nan_f64(z) || bessemer_complex_is_infinite_f64(z)
        || !bessemer_complex_is_finite_f64(&powers);
}

void complex_numbers_polar(const complex_number_f32_t *z, float share,
    complex_number_f32_t *BESSEMER_RESTRICT complex_number)
{
    pair_f32_f32_t r_angle;
    bessemer_complex_to_polar_f32(z, &r_angle);
    complex_number_f32_t turned_a;
    bessemer_complex_from_polar_f32(r_angle.first * share, r_angle.second, &turned_a);
    complex_number_f32_t turned_b;
    bessemer_complex_cis_f32(bessemer_complex_arg_f32(z), &turned_b);
    complex_number_f32_t turned;
    bessemer_complex_sum_f32(&turned_a, &turned_b, &turned);
    bessemer_complex_unscale_f32(&turned, bessemer_complex_norm_f32(z), complex_number);
}

void complex_numbers_strength(const complex_number_f64_t parts[3],
    double result[BESSEMER_RESTRICT 2])
{
    complex_number_f64_t sum = {.re = 0.0, .im = 0.0};
    for (uint32_t i = 0U; i < 3U; i++) {
        complex_number_f64_t sum_next;
        bessemer_complex_sum_f64(&sum, &parts[i], &sum_next);
        sum = sum_next;
    }
    result[0] = bessemer_complex_abs_f64(&sum);
    result[1] = bessemer_complex_norm_sqr_f64(&sum);
}

void complex_numbers_functions(const complex_number_f64_t *z,
    complex_number_f64_t result[BESSEMER_RESTRICT 5])
{
    complex_number_f64_t result_exp_f64;
    bessemer_complex_exp_f64(z, &result_exp_f64);
    complex_number_f64_t result_ln_f64;
    bessemer_complex_ln_f64(z, &result_ln_f64);
    complex_number_f64_t result_sqrt_f64;
    bessemer_complex_sqrt_f64(z, &result_sqrt_f64);
    complex_number_f64_t result_a;
    bessemer_complex_sin_f64(z, &result_a);
    complex_number_f64_t result_b;
    bessemer_complex_cos_f64(z, &result_b);
    complex_number_f64_t result_sum_f64;
    bessemer_complex_sum_f64(&result_a, &result_b, &result_sum_f64);
    complex_number_f64_t result_a_2;
    bessemer_complex_sinh_f64(z, &result_a_2);
    complex_number_f64_t result_b_2;
    bessemer_complex_cosh_f64(z, &result_b_2);
    complex_number_f64_t result_product_f64;
    bessemer_complex_product_f64(&result_a_2, &result_b_2, &result_product_f64);
    result[0] = result_exp_f64;
    result[1] = result_ln_f64;
    result[2] = result_sqrt_f64;
    result[3] = result_sum_f64;
    result[4] = result_product_f64;
}

void complex_numbers_polynomial_3(const double coefficients[3], const complex_number_f64_t *z,
    complex_number_f64_t *BESSEMER_RESTRICT value)
{
    *value = COMPLEX_DEFAULT;
    for (uint32_t i = 0U; i < 3U; i++) {
        complex_number_f64_t value_a;
        bessemer_complex_product_f64(value, z, &value_a);
        bessemer_complex_sum_with_real_f64(&value_a, coefficients[i], value);
    }
}

void complex_numbers_all_pass(double angle, option_complex_number_f64_t *result)
{
    const double value_coefficients[3] = {0.5, -1.0, 0.25};
    complex_number_f64_t value_z;
    bessemer_complex_cis_f64(angle, &value_z);
    complex_numbers_polynomial_3(value_coefficients, &value_z, &result->value);
    const complex_number_f64_t complex_number = {.re = 0.0, .im = 0.0};
    if (result->value.re == complex_number.re && result->value.im == complex_number.im) {
        *result = (option_complex_number_f64_t){.is_some = false};
    } else {
        result->is_some = true;
    }
}

/* resonator.c */

void resonator_init(resonator_t *self)
{
    self->state.re = 0.0F;
    self->state.im = 0.0F;
}

float resonator_step(resonator_t *BESSEMER_RESTRICT self, float sample,
    const complex_number_f32_t *pole)
{
    complex_number_f32_t state_a;
    bessemer_complex_product_f32(&self->state, pole, &state_a);
    bessemer_complex_sum_with_real_f32(&state_a, sample, &self->state);
    return self->state.re;
}

/* resonator.h */

/** A filter with one complex pole. */
typedef struct {
    /** State of the filter. */
    complex_number_f32_t state;
} resonator_t;
