/* The C of tests/corpus/src/programs/matrices/eigenvalues.rs. Written by a test. */

/* eigenvalues.c */

void eigenvalues_ellipsoid(const double covariance[9],
    pair_vector3_f64_matrix3x3_f64_t *BESSEMER_RESTRICT result)
{
    eigen_f64_3_t eigen;
    eigen_symmetric_f64_3(covariance, &eigen);
    for (uint32_t i = 0U; i < 3U; i++) {
        result->first[i] = sqrt(eigen.eigenvalues[i]);
    }
    (void)memcpy(result->second, eigen.eigenvectors, sizeof(double[9]));
}

double eigenvalues_condition(const double h[8])
{
    svd_f64_4_2_t result_self;
    svd_jacobi_f64_4_2(h, &result_self);
    return svd_f64_4_2_condition(&result_self);
}

void eigenvalues_allocated(const float effect[6], const float moment[3],
    float result[BESSEMER_RESTRICT 2])
{
    svd_f32_3_2_t result_self;
    svd_jacobi_f32_3_2(effect, &result_self);
    svd_f32_3_2_solve_1(&result_self, moment, 1e-6F, result);
}

void eigenvalues_shares(const double effect[10], pair_matrix2x5_f64_u32_t *BESSEMER_RESTRICT result)
{
    svd_f64_5_2_t parts;
    svd_jacobi_f64_5_2(effect, &parts);
    svd_f64_5_2_pseudo_inverse(&parts, 1e-6, result->first);
    result->second = (uint32_t)svd_f64_5_2_rank(&parts, 1e-6);
}
