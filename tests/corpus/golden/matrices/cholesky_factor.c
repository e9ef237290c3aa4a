/* The C of tests/corpus/src/programs/matrices/cholesky_factor.rs. Written by a test. */

/* cholesky_factor.c */

double cholesky_factor_surprise(const double s[9], const double difference[3])
{
    option_cholesky_factor_f64_3_t factor;
    cholesky_factored_f64_3(s, &factor);
    if (factor.is_some) {
        double result_solve_1[3];
        cholesky_factor_f64_3_solve_1(&factor.value, difference, result_solve_1);
        return difference[0] * result_solve_1[0] + difference[1] * result_solve_1[1]
            + difference[2] * result_solve_1[2];
    } else {
        return -1.0;
    }
}

void cholesky_factor_updated(const double p[4], const double x[2], double weight,
    option_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    option_cholesky_factor_f64_2_t factor_option;
    cholesky_factored_f64_2(p, &factor_option);
    if (!factor_option.is_some) {
        *result = (option_matrix2x2_f64_t){.is_some = false};
        return;
    }
    cholesky_factor_f64_2_t factor = factor_option.value;
    cholesky_factor_f64_2_rank_one_update(&factor, x, weight);
    cholesky_factor_f64_2_l(&factor, result->value);
    result->is_some = true;
}
