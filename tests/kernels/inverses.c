/* Prints the words of two inverses. */
#include "inverse_f32_50.h"
#include "inverse_f64_100.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static double next(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return (double)(*state >> 11) * 0x1p-53 - 0.5;
}

int main(void)
{
    static double a[10000];
    static float b[2500];
    static inverse_f64_100_work_t a_work;
    static inverse_f32_50_work_t b_work;
    uint64_t state = UINT64_C(88172645463325252);
    for (int index = 0; index < 10000; index++) {
        a[index] = next(&state);
    }
    for (int index = 0; index < 2500; index++) {
        b[index] = (float)next(&state);
    }
    if (!inverse_f64_100(a, &a_work) || !inverse_f32_50(b, &b_work)) {
        return 1;
    }
    for (int index = 0; index < 10000; index++) {
        uint64_t word;
        memcpy(&word, &a[index], sizeof word);
        printf("%" PRIu64 "\n", word);
    }
    for (int index = 0; index < 2500; index++) {
        uint32_t word;
        memcpy(&word, &b[index], sizeof word);
        printf("%" PRIu32 "\n", word);
    }
    return 0;
}
