/*
 * Runs each elementary function on the same arguments as its rivals: in turn against the clock, or,
 * compiled with COUNT, once between bench_begin and bench_end for each rival.
 *
 * functions.inc has a line for each: U (of one argument), B (of two) or T (of three, the first again as
 * the third), the name, the type, the functions, the ranges of the arguments.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <time.h>

#include "subjects.h"

/* Against the clock so many that branch predictors do not know them by heart. */
#ifdef COUNT
#define POINTS 2048
#else
#define POINTS 16384
#endif

static double xs[POINTS];
static double ys[POINTS];
static float xfs[POINTS];
static float yfs[POINTS];
static double outs[POINTS];
static float outfs[POINTS];

static uint64_t drawn;

static double draw(double low, double high)
{
    drawn += UINT64_C(0x9E3779B97F4A7C15);
    uint64_t word = drawn;
    word = (word ^ (word >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    word = (word ^ (word >> 27)) * UINT64_C(0x94D049BB133111EB);
    word ^= word >> 31;
    return low + (high - low) * ((double)(word >> 11) * 0x1p-53);
}

static void fill(double x_low, double x_high, double y_low, double y_high)
{
    drawn = 1;
    for (int i = 0; i < POINTS; i++) {
        xs[i] = draw(x_low, x_high);
        ys[i] = draw(y_low, y_high);
        xfs[i] = (float)xs[i];
        yfs[i] = (float)ys[i];
    }
}

#define double_X xs[i]
#define float_X xfs[i]
#define double_Y ys[i]
#define float_Y yfs[i]

#define double_OUT outs[i]
#define float_OUT outfs[i]

/* Kept one by one: a sum across calls would wait for itself. */
#define LOOP(type, call) \
    for (int i = 0; i < POINTS; i++) { \
        type##_OUT = call; \
    }

#ifdef COUNT

__attribute__((noinline)) double nothing_double(double x);
__attribute__((noinline)) float nothing_float(float x);
__attribute__((noinline)) double nothing2_double(double x, double y);
__attribute__((noinline)) float nothing2_float(float x, float y);
double nothing_double(double x) { __asm__ volatile(""); return x; }
float nothing_float(float x) { __asm__ volatile(""); return x; }
double nothing2_double(double x, double y) { __asm__ volatile(""); return x + 0 * y; }
float nothing2_float(float x, float y) { __asm__ volatile(""); return x + 0 * y; }
__attribute__((noinline)) double nothing3_double(double x, double y, double z);
__attribute__((noinline)) float nothing3_float(float x, float y, float z);
double nothing3_double(double x, double y, double z) { __asm__ volatile(""); return x + 0 * y * z; }
float nothing3_float(float x, float y, float z) { __asm__ volatile(""); return x + 0 * y * z; }
__attribute__((noinline)) void bench_begin(void);
__attribute__((noinline)) void bench_end(void);
void bench_begin(void) { __asm__ volatile(""); }
void bench_end(void) { __asm__ volatile(""); }
int *newlib___errno(void);
int *newlib___errno(void) { static int number; return &number; }

#define MEASURED(type, call) \
    bench_begin(); \
    LOOP(type, call) \
    bench_end();
#define U(name, type, ours, theirs, newlib, low, high) \
    fill(low, high, 0.0, 1.0); \
    MEASURED(type, nothing_##type(type##_X)) \
    MEASURED(type, ours(type##_X)) \
    MEASURED(type, theirs(type##_X)) \
    MEASURED(type, newlib(type##_X))
#define B(name, type, ours, theirs, newlib, low, high, y_low, y_high) \
    fill(low, high, y_low, y_high); \
    MEASURED(type, nothing2_##type(type##_X, type##_Y)) \
    MEASURED(type, ours(type##_X, type##_Y)) \
    MEASURED(type, theirs(type##_X, type##_Y)) \
    MEASURED(type, newlib(type##_X, type##_Y))
#define T(name, type, ours, theirs, newlib, low, high, y_low, y_high) \
    fill(low, high, y_low, y_high); \
    MEASURED(type, nothing3_##type(type##_X, type##_Y, type##_X)) \
    MEASURED(type, ours(type##_X, type##_Y, type##_X)) \
    MEASURED(type, theirs(type##_X, type##_Y, type##_X)) \
    MEASURED(type, newlib(type##_X, type##_Y, type##_X))

int main(void)
{
#include "functions.inc"
    return 0;
}

#else

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e9 + (double)time.tv_nsec;
}

#define TIMED(type, call) \
    { \
        const double start = now(); \
        LOOP(type, call) \
        printf(" %.3f", (now() - start) / POINTS); \
    }
#define U(name, type, ours, theirs, newlib, low, high) \
    fill(low, high, 0.0, 1.0); \
    printf("%s", name); \
    for (int round = 0; round < ROUNDS; round++) { \
        TIMED(type, ours(type##_X)) \
        TIMED(type, theirs(type##_X)) \
    } \
    puts("");
#define B(name, type, ours, theirs, newlib, low, high, y_low, y_high) \
    fill(low, high, y_low, y_high); \
    printf("%s", name); \
    for (int round = 0; round < ROUNDS; round++) { \
        TIMED(type, ours(type##_X, type##_Y)) \
        TIMED(type, theirs(type##_X, type##_Y)) \
    } \
    puts("");
#define T(name, type, ours, theirs, newlib, low, high, y_low, y_high) \
    fill(low, high, y_low, y_high); \
    printf("%s", name); \
    for (int round = 0; round < ROUNDS; round++) { \
        TIMED(type, ours(type##_X, type##_Y, type##_X)) \
        TIMED(type, theirs(type##_X, type##_Y, type##_X)) \
    } \
    puts("");

int main(void)
{
#include "functions.inc"
    return 0;
}

#endif
