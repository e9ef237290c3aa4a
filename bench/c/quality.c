/*
 * LAPACK's answers: reads `routine n` and the words of a matrix and a right-hand side, by columns, and writes
 * those of the result: of `solve` (dgesv) and `definite` (dposv) a vector, of `inverse` (dgetrf, dgetri) a matrix.
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

void dgesv_(const int *n, const int *columns, double *a, const int *lda, int *pivots, double *b, const int *ldb,
    int *info);
void dposv_(const char *half, const int *n, const int *columns, double *a, const int *lda, double *b,
    const int *ldb, int *info);
void dgetrf_(const int *m, const int *n, double *a, const int *lda, int *pivots, int *info);
void dgetri_(const int *n, double *a, const int *lda, const int *pivots, double *work, const int *length, int *info);

#define LARGEST 64

static double a[LARGEST * LARGEST];
static double b[LARGEST];
static double work[64 * LARGEST];

static int read_numbers(double *to, int count)
{
    for (int index = 0; index < count; index++) {
        uint64_t word;
        if (scanf("%" SCNx64, &word) != 1) {
            return 0;
        }
        memcpy(&to[index], &word, sizeof word);
    }
    return 1;
}

static void write_numbers(const double *from, int count)
{
    for (int index = 0; index < count; index++) {
        uint64_t word;
        memcpy(&word, &from[index], sizeof word);
        printf("%" PRIx64 " ", word);
    }
    puts("");
    fflush(stdout);
}

int main(void)
{
    char routine[16];
    int n;
    while (scanf("%15s %d", routine, &n) == 2 && n <= LARGEST && read_numbers(a, n * n) && read_numbers(b, n)) {
        const int one = 1;
        const int length = 64 * LARGEST;
        int pivots[LARGEST];
        int info = 0;
        if (strcmp(routine, "inverse") == 0) {
            dgetrf_(&n, &n, a, &n, pivots, &info);
            dgetri_(&n, a, &n, pivots, work, &length, &info);
            write_numbers(a, n * n);
            continue;
        }
        if (strcmp(routine, "solve") == 0) {
            dgesv_(&n, &one, a, &n, pivots, b, &n, &info);
        } else {
            dposv_("L", &n, &one, a, &n, b, &n, &info);
        }
        write_numbers(b, n);
    }
    return 0;
}
