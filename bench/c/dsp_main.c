/*
 * The program around the jobs of one contender: `cargo xtask bench --only dsp`.
 */
#include "dsp.h"

#include <stdio.h>
#include <string.h>

#ifdef DSP_BARE
extern FILE *words_out;
#else
#define words_out stdout
#endif

__attribute__((noinline)) void bench_begin(void)
{
    __asm__ volatile("" ::: "memory");
}

__attribute__((noinline)) void bench_end(void)
{
    __asm__ volatile("" ::: "memory");
}

void report(const float *results, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t bits = 0;
        (void)memcpy(&bits, &results[i], sizeof bits);
        unsigned char bytes[8] = {0};
        for (size_t k = 0; k < 4; k++) {
            bytes[k] = (unsigned char)(bits >> (8 * k));
        }
        (void)fwrite(bytes, 1, sizeof bytes, words_out);
    }
}

int main(void)
{
    run_jobs();
    return fflush(words_out) == 0 ? 0 : 1;
}
