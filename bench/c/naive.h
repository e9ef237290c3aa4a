/*
 * Small sizes as they are written by hand: loops over constant bounds, by columns, in place on a copy. Included
 * once for each size and type, with N, REAL, SQRT, ABS and NAME.
 */
static void NAME(lu_solve)(const REAL *a, const REAL *b, REAL *x)
{
    REAL lu[N * N];
    for (int i = 0; i < N * N; i++) {
        lu[i] = a[i];
    }
    for (int i = 0; i < N; i++) {
        x[i] = b[i];
    }
    for (int k = 0; k < N; k++) {
        int pivot = k;
        for (int i = k + 1; i < N; i++) {
            if (ABS(lu[i + N * k]) > ABS(lu[pivot + N * k])) {
                pivot = i;
            }
        }
        if (pivot != k) {
            for (int j = k; j < N; j++) {
                const REAL value = lu[k + N * j];
                lu[k + N * j] = lu[pivot + N * j];
                lu[pivot + N * j] = value;
            }
            const REAL value = x[k];
            x[k] = x[pivot];
            x[pivot] = value;
        }
        for (int i = k + 1; i < N; i++) {
            const REAL factor = lu[i + N * k] / lu[k + N * k];
            for (int j = k + 1; j < N; j++) {
                lu[i + N * j] -= factor * lu[k + N * j];
            }
            x[i] -= factor * x[k];
        }
    }
    for (int i = N - 1; i >= 0; i--) {
        for (int j = i + 1; j < N; j++) {
            x[i] -= lu[i + N * j] * x[j];
        }
        x[i] /= lu[i + N * i];
    }
}

static void NAME(inverse)(const REAL *a, REAL *x)
{
    REAL lu[N * N];
    for (int i = 0; i < N * N; i++) {
        lu[i] = a[i];
        x[i] = (i % (N + 1) == 0) ? 1 : 0;
    }
    for (int k = 0; k < N; k++) {
        int pivot = k;
        for (int i = k + 1; i < N; i++) {
            if (ABS(lu[i + N * k]) > ABS(lu[pivot + N * k])) {
                pivot = i;
            }
        }
        if (pivot != k) {
            for (int j = 0; j < N; j++) {
                REAL value = lu[k + N * j];
                lu[k + N * j] = lu[pivot + N * j];
                lu[pivot + N * j] = value;
                value = x[k + N * j];
                x[k + N * j] = x[pivot + N * j];
                x[pivot + N * j] = value;
            }
        }
        const REAL scale = 1 / lu[k + N * k];
        for (int j = 0; j < N; j++) {
            lu[k + N * j] *= scale;
            x[k + N * j] *= scale;
        }
        for (int i = 0; i < N; i++) {
            if (i != k) {
                const REAL factor = lu[i + N * k];
                for (int j = k; j < N; j++) {
                    lu[i + N * j] -= factor * lu[k + N * j];
                }
                for (int j = 0; j < N; j++) {
                    x[i + N * j] -= factor * x[k + N * j];
                }
            }
        }
    }
}

static void NAME(cholesky_solve)(const REAL *a, const REAL *b, REAL *x)
{
    REAL l[N * N];
    for (int j = 0; j < N; j++) {
        REAL sum = a[j + N * j];
        for (int k = 0; k < j; k++) {
            sum -= l[j + N * k] * l[j + N * k];
        }
        l[j + N * j] = SQRT(sum);
        for (int i = j + 1; i < N; i++) {
            sum = a[i + N * j];
            for (int k = 0; k < j; k++) {
                sum -= l[i + N * k] * l[j + N * k];
            }
            l[i + N * j] = sum / l[j + N * j];
        }
    }
    for (int i = 0; i < N; i++) {
        REAL sum = b[i];
        for (int k = 0; k < i; k++) {
            sum -= l[i + N * k] * x[k];
        }
        x[i] = sum / l[i + N * i];
    }
    for (int i = N - 1; i >= 0; i--) {
        REAL sum = x[i];
        for (int k = i + 1; k < N; k++) {
            sum -= l[k + N * i] * x[k];
        }
        x[i] = sum / l[i + N * i];
    }
}

static void NAME(product)(const REAL *a, const REAL *b, REAL *x)
{
    for (int j = 0; j < N; j++) {
        for (int i = 0; i < N; i++) {
            REAL sum = 0;
            for (int k = 0; k < N; k++) {
                sum += a[i + N * k] * b[k + N * j];
            }
            x[i + N * j] = sum;
        }
    }
}
