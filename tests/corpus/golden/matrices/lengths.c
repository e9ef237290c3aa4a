/* The C of tests/corpus/src/programs/matrices/lengths.rs. Written by a test. */

/* lengths.c */

void lengths_direction(const double v[3], option_vector3_f64_t *BESSEMER_RESTRICT result)
{
    norms_try_normalize_f64_3_1(v, 1e-9, result);
}

void lengths_feasible(const float acceleration[3], float most, float result[BESSEMER_RESTRICT 3])
{
    norms_cap_magnitude_f32_3_1(acceleration, most, result);
}

void lengths_between(const double a[2], const double b[2],
    pair_vector2_f64_f64_t *BESSEMER_RESTRICT result)
{
    elementwise_lerp_f64_2(a, b, 0.5, result->first);
    result->second = norms_metric_distance_f64_2_1(a, b);
}

bool lengths_turns(const double a[9])
{
    return norms_is_special_orthogonal_f64_3(a, 1e-9);
}
