/*
 * Reads pairs of doubles and calls one elementary function on each pair, in both formats; prints the
 * folded bits of the results, in which every NaN is the same.
 *
 * functions.inc has a line for each function: U (of one argument) or B (of two), its number, the functions.
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "subjects.h"

#define PAIRS 4096

static double pairs[2 * PAIRS];
static uint64_t folded;

static void fold(uint64_t bits)
{
    folded = (folded ^ bits) * UINT64_C(0x9E3779B97F4A7C15);
    folded ^= folded >> 29;
}

static void fold_double(double value)
{
    uint64_t bits = UINT64_MAX;
    if (value == value) {
        memcpy(&bits, &value, sizeof bits);
    }
    fold(bits);
}

static void fold_float(float value)
{
    uint32_t bits = UINT32_MAX;
    if (value == value) {
        memcpy(&bits, &value, sizeof bits);
    }
    fold(bits);
}

#define U(number, wide, narrow) \
    case number: \
        fold_double(wide(x)); \
        fold_float(narrow((float)x)); \
        break;
#define B(number, wide, narrow) \
    case number: \
        fold_double(wide(x, y)); \
        fold_float(narrow((float)x, (float)y)); \
        break;

static void call(int which, double x, double y)
{
    switch (which) {
#include "functions.inc"
    default:
        abort();
    }
}

int main(int argc, char **argv)
{
    const int which = (argc > 1) ? atoi(argv[1]) : -1;
    size_t count = fread(pairs, 2 * sizeof pairs[0], PAIRS, stdin);
    while (count > 0) {
        for (size_t n = 0; n < count; n++) {
            call(which, pairs[2 * n], pairs[2 * n + 1]);
        }
        count = fread(pairs, 2 * sizeof pairs[0], PAIRS, stdin);
    }
    printf("%016" PRIx64 "\n", folded);
    return 0;
}
