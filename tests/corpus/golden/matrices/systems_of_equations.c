/* The C of tests/corpus/src/programs/matrices/systems_of_equations.rs. Written by a test. */

/* systems_of_equations.c */

void systems_of_equations_parabola(const double x[3], const double y[3],
    double coefficients[BESSEMER_RESTRICT 3])
{
    double powers[9];
    for (uint32_t row = 0U; row < 3U; row++) {
        powers[row + 3U * 0U] = 1.0;
        powers[row + 3U * 1U] = x[row];
        powers[row + 3U * 2U] = x[row] * x[row];
    }
    coefficients[0] = y[0];
    coefficients[1] = y[1];
    coefficients[2] = y[2];
    (void)lu_solve_f64_3(powers, coefficients);
}

void systems_of_equations_gain(const double p[36], const double r[36],
    double work_numbers[BESSEMER_RESTRICT 36],
    inverse_f64_6_work_t *BESSEMER_RESTRICT work_inverse_f64_6_work,
    double result[BESSEMER_RESTRICT 36])
{
    double *const inverse = work_numbers;
    for (uint32_t i = 0U; i < 36U; i++) {
        inverse[i] = p[i] + r[i];
    }
    if (inverse_f64_6(inverse, work_inverse_f64_6_work)) {
        product_f64_6x6_6x6(p, inverse, result);
    } else {
        for (uint32_t i = 0U; i < 36U; i++) {
            result[i] = 0.0;
        }
    }
}

bool systems_of_equations_keeps_handedness(const float turn[9])
{
    return determinant_f32_3(turn) > 0.0F;
}
