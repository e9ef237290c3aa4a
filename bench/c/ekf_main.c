/*
 * The program around the filter of one contender: `cargo xtask bench --only ekf`.
 */
#include "ekf.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#ifdef BENCH_BARE
extern FILE *words_out;
#else
#define words_out stdout
#endif

#define STEPS 20

__attribute__((noinline)) void bench_begin(void)
{
    __asm__ volatile("" ::: "memory");
}

__attribute__((noinline)) void bench_end(void)
{
    __asm__ volatile("" ::: "memory");
}

static void report(const real *results, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const double number = (double)results[i];
        uint64_t bits = 0;
        (void)memcpy(&bits, &number, sizeof bits);
        unsigned char bytes[8] = {0};
        for (size_t k = 0; k < 8; k++) {
            bytes[k] = (unsigned char)(bits >> (8 * k));
        }
        (void)fwrite(bytes, 1, sizeof bytes, words_out);
    }
}

/* Returns a number from -1 to 1. */
static real next(uint32_t *seed)
{
    *seed = *seed * 1664525U + 1013904223U;
    return (real)(int32_t)(*seed >> 8U) * (real)0x1p-23 - (real)1.0;
}

int main(void)
{
    static real state[STATES];
    static real covariance[HALF];
    real spread[STATES];
    const real variances[4] = {(real)1.0, (real)0.1, (real)0.01, (real)1e-4};
    for (size_t i = 0; i < STATES; i++) {
        spread[i] = variances[i / 3];
    }
    start(spread);
    uint32_t seed = 7U;
    for (size_t i = 0; i < STEPS; i++) {
        real rate[3];
        real force[3] = {0, 0, (real)-9.81};
        real measured[6];
        for (size_t k = 0; k < 3; k++) {
            rate[k] = (real)0.3 * next(&seed);
            force[k] += next(&seed);
        }
        for (size_t k = 0; k < 6; k++) {
            measured[k] = (real)0.1 * next(&seed);
        }
        bench_begin();
        step(rate, force, (real)0.004, measured);
        bench_end();
    }
    finish(state, covariance);
    report(state, STATES);
    report(covariance, HALF);
    real six[6];
    bench_begin();
    angles(&state[6], six);
    bench_end();
    report(six, 6);
    return fflush(words_out) == 0 ? 0 : 1;
}
