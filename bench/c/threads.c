/*
 * Large kernels, on as many threads as BESSEMER_THREADS says, or on one.
 *
 *   program ROUNDS   a line for each kernel: its name, the words of its result folded, the nanoseconds of each round
 */
#define _POSIX_C_SOURCE 199309L

#include "inverse_f64_100.h"
#include "inverse_f64_400.h"
#include "product_f64_400x400_400x400.h"
#include "solve_f64_400x400.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define LARGEST 400
#define NUMBERS ((size_t)(LARGEST * LARGEST))

static double left[NUMBERS];
static double right[NUMBERS];
static double result[NUMBERS];
static inverse_f64_100_work_t inverse_100_work;
static inverse_f64_400_work_t inverse_400_work;
static solve_f64_400x400_work_t solve_work;

static void fill(double *numbers, uint64_t state)
{
    for (size_t index = 0; index < NUMBERS; index++) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        numbers[index] = (double)(state >> 11) * 0x1p-53;
    }
}

static void invert_100(void)
{
    memcpy(result, left, 100 * 100 * sizeof(double));
    (void)inverse_f64_100(result, &inverse_100_work);
}

static void invert_400(void)
{
    memcpy(result, left, sizeof result);
    (void)inverse_f64_400(result, &inverse_400_work);
}

static void solve_400(void)
{
    memcpy(result, right, sizeof result);
    (void)solve_f64_400x400(left, result, &solve_work);
}

static void multiply_400(void)
{
    product_f64_400x400_400x400(left, right, result);
}

static uint64_t nanoseconds(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * UINT64_C(1000000000) + (uint64_t)now.tv_nsec;
}

static void run(const char *name, size_t numbers, int rounds, void (*kernel)(void))
{
    uint64_t folded = 0;
    kernel();
    for (size_t index = 0; index < numbers; index++) {
        uint64_t word;
        memcpy(&word, &result[index], sizeof word);
        folded = (folded ^ word) * UINT64_C(0x9E3779B97F4A7C15);
    }
    printf("%s %" PRIu64, name, folded);
    for (int round = 0; round < rounds; round++) {
        const uint64_t start = nanoseconds();
        kernel();
        printf(" %" PRIu64, nanoseconds() - start);
    }
    printf("\n");
}

int main(int count, char **arguments)
{
    const int rounds = (count > 1) ? atoi(arguments[1]) : 1;
    fill(left, UINT64_C(88172645463325252));
    fill(right, UINT64_C(1442695040888963407));
    run("inverse_100", 100 * 100, rounds, invert_100);
    run("inverse_400", NUMBERS, rounds, invert_400);
    run("solve_400x400", NUMBERS, rounds, solve_400);
    run("product_400", NUMBERS, rounds, multiply_400);
    return 0;
}
