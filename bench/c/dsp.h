/*
 * What the programs of `cargo xtask bench --only dsp` have in common: marks around a job, its inputs and its results.
 */
#ifndef DSP_H
#define DSP_H

#include <stddef.h>
#include <stdint.h>

/* The plugin of QEMU counts between these calls. */
void bench_begin(void);
void bench_end(void);

/* Returns a number of which the compiler knows nothing, in a register of the caller. */
static inline float unknown(float number)
{
#if defined(__arm__)
    __asm__ volatile("" : "+t"(number));
#endif
    return number;
}

/* Has the compiler compute a number here. */
static inline void computed(float number)
{
#if defined(__arm__)
    __asm__ volatile("" : : "t"(number));
#else
    (void)number;
#endif
}

/* Writes the results of a job, each as a word with the bits of the number. */
void report(const float *results, size_t count);

/* Fills an array with numbers from -1 to 1 that follow from a seed. */
static inline void fill(float *numbers, size_t count, uint32_t seed)
{
    uint32_t state = seed;
    for (size_t i = 0; i < count; i++) {
        state = state * 1664525U + 1013904223U;
        numbers[i] = (float)(int32_t)(state >> 8U) * 0x1p-23f - 1.0f;
    }
}

/* Runs every job of a contender, in the order of the table in `bench/src/dsp.rs`. */
void run_jobs(void);

#endif
