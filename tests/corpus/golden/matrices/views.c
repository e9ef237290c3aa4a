/* The C of tests/corpus/src/programs/matrices/views.rs. Written by a test. */

/* programs_matrices_views.c */

double programs_matrices_views_along(const double axes[9])
{
    const double result_vector[3] = {axes[0 + 3 * 0], axes[1 + 3 * 0], axes[2 + 3 * 0]};
    const double result_vector_2[3] = {axes[0 + 3 * 1], axes[1 + 3 * 1], axes[2 + 3 * 1]};
    return result_vector[0] * result_vector_2[0] + result_vector[1] * result_vector_2[1]
        + result_vector[2] * result_vector_2[2];
}

void programs_matrices_views_attitude(const double covariance[36],
    double result[BESSEMER_RESTRICT 9])
{
    result[0 + 3 * 0] = covariance[3 + 6 * 3];
    result[1 + 3 * 0] = covariance[4 + 6 * 3];
    result[2 + 3 * 0] = covariance[5 + 6 * 3];
    result[0 + 3 * 1] = covariance[3 + 6 * 4];
    result[1 + 3 * 1] = covariance[4 + 6 * 4];
    result[2 + 3 * 1] = covariance[5 + 6 * 4];
    result[0 + 3 * 2] = covariance[3 + 6 * 5];
    result[1 + 3 * 2] = covariance[4 + 6 * 5];
    result[2 + 3 * 2] = covariance[5 + 6 * 5];
}

void programs_matrices_views_moved(const double state[6], const double velocity[3],
    double next[BESSEMER_RESTRICT 6])
{
    (void)memcpy(next, state, sizeof(double[6]));
    for (uint32_t row = 0U; row < 3U; row++) {
        next[row + 3U] = velocity[row];
    }
    double part[3] = {next[0], next[1], next[2]};
    part[0] *= 0.5;
    part[1] *= 0.5;
    part[2] *= 0.5;
    for (uint32_t row = 0U; row < 3U; row++) {
        next[row] = part[row];
    }
}
