/* The C of tests/corpus/src/programs/matrices/swizzles.rs. Written by a test. */

/* swizzles.c */

void swizzles_in_the_plane(const double from[3], const double to[3],
    pair_f64_f64_t *BESSEMER_RESTRICT result)
{
    const double way[2] = {to[0] - from[0], to[1] - from[1]};
    const double vector[2] = {way[1], way[0]};
    result->first = sqrt(way[0] * way[0] + way[1] * way[1]);
    result->second = vector[0];
}

void swizzles_turned(const float state[6], float result[BESSEMER_RESTRICT 3])
{
    const float swapped[3] = {state[1], state[0], state[2]};
    result[0] = swapped[0];
    result[1] = swapped[1];
    result[2] = -swapped[2];
}

void swizzles_of_a_sum(const double a[4], const double b[4], double result[BESSEMER_RESTRICT 3])
{
    const double vector[4] = {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
    const double vector_2[3] = {a[0], a[1], a[2]};
    result[0] = vector[2] - vector_2[2];
    result[1] = vector[2] - vector_2[1];
    result[2] = vector[0] - vector_2[0];
}

void swizzles_of_others(const int32_t a[2], const double m[9],
    pair_vector2_i32_vector2_f64_t *BESSEMER_RESTRICT result)
{
    const double vector[3] = {m[0 + 3 * 1], m[1 + 3 * 1], m[2 + 3 * 1]};
    result->first[0] = a[1];
    result->first[1] = a[0];
    result->second[0] = vector[0];
    result->second[1] = vector[2];
}
