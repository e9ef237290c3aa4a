/*
 * The program around the gradient of one contender: `cargo xtask bench --only gradient`.
 */
#include "gradient.h"

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

/* Descends from a hover. */
int main(void)
{
    static real inputs[INPUTS];
    const real start[STATES] = {0, 0, 0, (real)0.5, (real)0.1};
    real cost = 0;
    const real *slopes = 0;
    for (size_t i = 0; i < INPUTS; i += 2) {
        inputs[i] = (real)9.81;
        inputs[i + 1] = (real)0.01;
    }
    for (size_t i = 0; i < STEPS; i++) {
        bench_begin();
        slopes = step(start, inputs, (real)0.02, &cost);
        bench_end();
        for (size_t k = 0; k < INPUTS; k++) {
            inputs[k] -= (real)0.001 * slopes[k];
        }
    }
    report(&cost, 1);
    report(slopes, INPUTS);
    real two[2];
    bench_begin();
    angles(inputs[1], two);
    bench_end();
    report(two, 2);
    return fflush(words_out) == 0 ? 0 : 1;
}
