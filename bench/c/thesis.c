/*
 * The handwritten C that the thesis describes (section 6): Gaussian elimination without pivoting on row-major
 * arrays, the ratio of two rows held in a float, the inner loop over the whole row; the inverse by Crout's LU
 * without pivoting, then two substitutions for each column of the identity.
 */
#include "case.h"

#include <string.h>

#define N 200
#define M 100

static double a[N][N + 1]; /* the right-hand side in the last column */
static double c[M][M];
static double inverse[M][M];

static void load_solve(void)
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            a[i][j] = matrix.f64[i + N * j];
        }
        a[i][N] = vector.f64[i];
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

__attribute__((noinline)) static void solve(void)
{
    for (int i = 0; i < N - 1; i++) {
        for (int j = i + 1; j < N; j++) {
            float ratio = (float)(a[j][i] / a[i][i]);
            for (int k = 0; k < N + 1; k++) {
                a[j][k] = a[j][k] - (double)ratio * a[i][k];
            }
        }
    }
    for (int i = N - 1; i >= 0; i--) {
        double sum = a[i][N];
        for (int j = i + 1; j < N; j++) {
            sum = sum - a[i][j] * result.f64[j];
        }
        result.f64[i] = sum / a[i][i];
    }
}

__attribute__((noinline)) static void invert(void)
{
    double l[M][M];
    double u[M][M];
    double y[M];
    memset(l, 0, sizeof l);
    memset(u, 0, sizeof u);
    for (int j = 0; j < M; j++) {
        u[j][j] = 1.0;
        for (int i = j; i < M; i++) {
            double sum = 0.0;
            for (int k = 0; k < j; k++) {
                sum = sum + l[i][k] * u[k][j];
            }
            l[i][j] = c[i][j] - sum;
        }
        for (int i = j + 1; i < M; i++) {
            double sum = 0.0;
            for (int k = 0; k < j; k++) {
                sum = sum + l[j][k] * u[k][i];
            }
            u[j][i] = (c[j][i] - sum) / l[j][j];
        }
    }
    for (int column = 0; column < M; column++) {
        for (int i = 0; i < M; i++) {
            double sum = 0.0;
            for (int k = 0; k < i; k++) {
                sum = sum + l[i][k] * y[k];
            }
            y[i] = ((i == column ? 1.0 : 0.0) - sum) / l[i][i];
        }
        for (int i = M - 1; i >= 0; i--) {
            double sum = 0.0;
            for (int k = i + 1; k < M; k++) {
                sum = sum + u[i][k] * inverse[k][column];
            }
            inverse[i][column] = y[i] - sum;
        }
    }
}

const case_t CASES[] = {
    {"lu_solve_f64_200", LU_SOLVE, N, 0, load_solve, solve, 0},
    {"inverse_f64_100", INVERSE, M, 0, load_inverse, invert, store_inverse},
};
const size_t CASE_COUNT = sizeof CASES / sizeof CASES[0];
