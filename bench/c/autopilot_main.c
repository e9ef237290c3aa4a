/*
 * The program around the autopilot's filter of one contender: `cargo xtask bench --only autopilot`.
 */
#include "autopilot_bench.h"

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
    static real state[STATES] = {1, [16] = (real)0.2, (real)0.02, (real)0.4};
    static real covariance[HALF];
    real spread[STATES];
    const real variances[8] = {
        (real)0.01, (real)0.1, (real)1.0, (real)1e-4, (real)0.01, (real)0.01, (real)0.01, (real)1.0
    };
    const size_t first[9] = {0, 4, 7, 10, 13, 16, 19, 22, 24};
    for (size_t block = 0; block < 8; block++) {
        for (size_t i = first[block]; i < first[block + 1]; i++) {
            spread[i] = variances[block];
        }
    }
    start(state, spread);
    uint32_t seed = 7U;
    for (size_t i = 0; i < STEPS; i++) {
        real rate[3];
        real force[3] = {0, 0, (real)-9.80665};
        real placed[6];
        real field[3] = {(real)0.2, (real)0.02, (real)0.4};
        for (size_t k = 0; k < 3; k++) {
            rate[k] = (real)0.3 * next(&seed);
            force[k] += next(&seed);
            field[k] += (real)0.02 * next(&seed);
        }
        for (size_t k = 0; k < 6; k++) {
            placed[k] = (real)0.1 * next(&seed);
        }
        bench_begin();
        predict(rate, force, (real)0.004);
        bench_end();
        bench_begin();
        place(placed);
        bench_end();
        bench_begin();
        compass(field);
        bench_end();
    }
    finish(state, covariance);
    report(state, STATES);
    report(covariance, HALF);
    return fflush(words_out) == 0 ? 0 : 1;
}
