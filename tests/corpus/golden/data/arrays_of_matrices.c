/* The C of tests/corpus/src/programs/data/arrays_of_matrices.rs. Written by a test. */

/* arrays_of_matrices.c */

void arrays_of_matrices_centre(const double points[4][2], double result[BESSEMER_RESTRICT 2])
{
    double sum[2] = {0.0, 0.0};
    for (uint32_t i = 0U; i < 4U; i++) {
        sum[0] += points[i][0];
        sum[1] += points[i][1];
    }
    result[0] = sum[0] / 4.0;
    result[1] = sum[1] / 4.0;
}
