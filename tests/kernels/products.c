/* Prints the words of two products. */
#include "product_f32_9x9_9x9.h"
#include "product_f64_20x20_20x20.h"

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
    static double a[400], b[400], result[400];
    static float c[81], d[81], single[81];
    uint64_t state = UINT64_C(88172645463325252);
    for (int index = 0; index < 400; index++) {
        a[index] = next(&state);
        b[index] = next(&state);
    }
    for (int index = 0; index < 81; index++) {
        c[index] = (float)next(&state);
        d[index] = (float)next(&state);
    }
    product_f64_20x20_20x20(a, b, result);
    product_f32_9x9_9x9(c, d, single);
    for (int index = 0; index < 400; index++) {
        uint64_t word;
        memcpy(&word, &result[index], sizeof word);
        printf("%" PRIu64 "\n", word);
    }
    for (int index = 0; index < 81; index++) {
        uint32_t word;
        memcpy(&word, &single[index], sizeof word);
        printf("%" PRIu32 "\n", word);
    }
    return 0;
}
