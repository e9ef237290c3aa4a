/* LAPACK, OpenBLAS's or the reference: the same calls, another library. */
#include "case.h"

#include <string.h>

void dgesv_(const int *n, const int *columns, double *a, const int *lda, int *pivots, double *b, const int *ldb,
    int *info);
void dgetrf_(const int *m, const int *n, double *a, const int *lda, int *pivots, int *info);
void dgetri_(const int *n, double *a, const int *lda, const int *pivots, double *work, const int *length, int *info);

#define WORK 6400

static double a[ROOM];
static double work[WORK];
static int pivots[200];

static void load_solve(void)
{
    memcpy(a, matrix.f64, sizeof a);
    memcpy(result.f64, vector.f64, 200 * sizeof(double));
}

static void load_inverse(void)
{
    memcpy(result.f64, matrix.f64, 10000 * sizeof(double));
}

static void solve(void)
{
    const int n = 200;
    const int one = 1;
    int info = 0;
    dgesv_(&n, &one, a, &n, pivots, result.f64, &n, &info);
}

static void invert(void)
{
    const int n = 100;
    const int length = WORK;
    int info = 0;
    dgetrf_(&n, &n, result.f64, &n, pivots, &info);
    dgetri_(&n, result.f64, &n, pivots, work, &length, &info);
}

const case_t CASES[] = {
    {"lu_solve_f64_200", LU_SOLVE, 200, 0, load_solve, solve, 0},
    {"inverse_f64_100", INVERSE, 100, 0, load_inverse, invert, 0},
};
const size_t CASE_COUNT = sizeof CASES / sizeof CASES[0];
