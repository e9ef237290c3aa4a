/* The C of tests/corpus/src/programs/matrices/quadratic_forms.rs. Written by a test. */

/* quadratic_forms.c */

void quadratic_forms_predicted(const double a[9], const double p[9], const double q[9],
    double grown[BESSEMER_RESTRICT 9])
{
    (void)memcpy(grown, q, sizeof(double[9]));
    blas_quadform_tr_f64_3_3(grown, 1.0, a, p, 1.0);
}

void quadratic_forms_information(const double h[8], const double w[16],
    double sum[BESSEMER_RESTRICT 4])
{
    sum[0] = 0.0;
    sum[1] = 0.0;
    sum[2] = 0.0;
    sum[3] = 0.0;
    blas_quadform_f64_4_2(sum, 1.0, w, h, 0.0);
}

void quadratic_forms_gradient(const float h[8], const float residual[4],
    float gradient[BESSEMER_RESTRICT 2])
{
    gradient[0] = 0.0F;
    gradient[1] = 0.0F;
    blas_gemv_tr_f32_4_2(gradient, 2.0F, h, residual, 0.0F);
}
