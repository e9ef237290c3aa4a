/*
 * The program around one solver: `cargo xtask bench --only qp`.
 */
#include "qp.h"

#include "problem.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

__attribute__((noinline)) void bench_begin(void)
{
    __asm__ volatile("" ::: "memory");
}

__attribute__((noinline)) void bench_end(void)
{
    __asm__ volatile("" ::: "memory");
}

int main(void)
{
    start();
    for (size_t i = 0; i < STEPS; i++) {
        double input[NU] = {0};
        bench_begin();
        step(&STATES[NX * i], input);
        bench_end();
        for (size_t k = 0; k < NU; k++) {
            uint64_t bits = 0;
            (void)memcpy(&bits, &input[k], sizeof bits);
            unsigned char bytes[8] = {0};
            for (size_t n = 0; n < 8; n++) {
                bytes[n] = (unsigned char)(bits >> (8 * n));
            }
            (void)fwrite(bytes, 1, sizeof bytes, stdout);
        }
    }
    return fflush(stdout) == 0 ? 0 : 1;
}
