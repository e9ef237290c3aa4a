/* The C of tests/corpus/src/programs/matrices/powers_of_matrices.rs. Written by a test. */

/* powers_of_matrices.c */

void powers_of_matrices_ahead(const double a[4], uint32_t steps, double result[BESSEMER_RESTRICT 4])
{
    matrix_powers_pow_f64_2(a, steps, result);
}

void powers_of_matrices_transition(const double a[4], double time,
    double result[BESSEMER_RESTRICT 4])
{
    const double result_a[4] = {
        a[0 + 2 * 0] * time,
        a[1 + 2 * 0] * time,
        a[0 + 2 * 1] * time,
        a[1 + 2 * 1] * time
    };
    matrix_powers_exp_f64_2(result_a, result);
}
