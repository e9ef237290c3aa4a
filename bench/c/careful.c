/*
 * What a careful engineer writes by hand: row-major arrays, row pivoting by exchanging rows, contiguous inner loops,
 * all right-hand sides of the inverse at once.
 */
#include "case.h"

#include <math.h>
#include <string.h>

#define N 200
#define M 100

static double a[N][N];
static double b[N];
static double c[M][M];
static double inverse[M][M];

static void load_solve(void)
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            a[i][j] = matrix.f64[i + N * j];
        }
        b[i] = vector.f64[i];
    }
}

static void load_inverse(void)
{
    for (int i = 0; i < M; i++) {
        for (int j = 0; j < M; j++) {
            c[i][j] = matrix.f64[i + M * j];
        }
    }
}

static void store_inverse(void)
{
    for (int i = 0; i < M; i++) {
        for (int j = 0; j < M; j++) {
            result.f64[i + M * j] = inverse[i][j];
        }
    }
}

static void exchange(double *restrict x, double *restrict y, int count)
{
    for (int j = 0; j < count; j++) {
        const double value = x[j];
        x[j] = y[j];
        y[j] = value;
    }
}

__attribute__((noinline)) static void solve(void)
{
    for (int k = 0; k < N; k++) {
        int pivot = k;
        for (int i = k + 1; i < N; i++) {
            if (fabs(a[i][k]) > fabs(a[pivot][k])) {
                pivot = i;
            }
        }
        if (pivot != k) {
            exchange(&a[k][k], &a[pivot][k], N - k);
            exchange(&b[k], &b[pivot], 1);
        }
        const double *restrict row = a[k];
        for (int i = k + 1; i < N; i++) {
            double *restrict other = a[i];
            const double factor = other[k] / row[k];
            for (int j = k + 1; j < N; j++) {
                other[j] -= factor * row[j];
            }
            b[i] -= factor * b[k];
        }
    }
    for (int i = N - 1; i >= 0; i--) {
        double sum = b[i];
        for (int j = i + 1; j < N; j++) {
            sum -= a[i][j] * result.f64[j];
        }
        result.f64[i] = sum / a[i][i];
    }
}

__attribute__((noinline)) static void invert(void)
{
    memset(inverse, 0, sizeof inverse);
    for (int i = 0; i < M; i++) {
        inverse[i][i] = 1.0;
    }
    for (int k = 0; k < M; k++) {
        int pivot = k;
        for (int i = k + 1; i < M; i++) {
            if (fabs(c[i][k]) > fabs(c[pivot][k])) {
                pivot = i;
            }
        }
        if (pivot != k) {
            exchange(&c[k][k], &c[pivot][k], M - k);
            exchange(inverse[k], inverse[pivot], M);
        }
        for (int i = k + 1; i < M; i++) {
            const double factor = c[i][k] / c[k][k];
            double *restrict other = c[i];
            const double *restrict row = c[k];
            for (int j = k + 1; j < M; j++) {
                other[j] -= factor * row[j];
            }
            double *restrict right = inverse[i];
            const double *restrict from = inverse[k];
            for (int j = 0; j < M; j++) {
                right[j] -= factor * from[j];
            }
        }
    }
    for (int i = M - 1; i >= 0; i--) {
        double *restrict row = inverse[i];
        for (int k = i + 1; k < M; k++) {
            const double factor = c[i][k];
            const double *restrict other = inverse[k];
            for (int j = 0; j < M; j++) {
                row[j] -= factor * other[j];
            }
        }
        const double scale = 1.0 / c[i][i];
        for (int j = 0; j < M; j++) {
            row[j] *= scale;
        }
    }
}

const case_t CASES[] = {
    {"lu_solve_f64_200", LU_SOLVE, N, 0, load_solve, solve, 0},
    {"inverse_f64_100", INVERSE, M, 0, load_inverse, invert, store_inverse},
};
const size_t CASE_COUNT = sizeof CASES / sizeof CASES[0];
