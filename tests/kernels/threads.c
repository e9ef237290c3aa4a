/* Prints the words of two inverses, of solutions and of a product. */
#include "inverse_f32_50.h"
#include "inverse_f64_100.h"
#include "product_f64_65x90_90x70.h"
#include "solve_f64_90x50.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static uint64_t state = UINT64_C(88172645463325252);

static double next(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53 - 0.5;
}

static void fill(double *numbers, int count)
{
    for (int index = 0; index < count; index++) {
        numbers[index] = next();
    }
}

static void print(const double *numbers, int count)
{
    for (int index = 0; index < count; index++) {
        uint64_t word;
        memcpy(&word, &numbers[index], sizeof word);
        printf("%" PRIu64 "\n", word);
    }
}

int main(void)
{
    static double a[10000];
    static float b[2500];
    static double left[90 * 90];
    static double right[90 * 70];
    static double result[65 * 70];
    static inverse_f64_100_work_t a_work;
    static inverse_f32_50_work_t b_work;
    static solve_f64_90x50_work_t solve_work;
    fill(a, 10000);
    for (int index = 0; index < 2500; index++) {
        b[index] = (float)next();
    }
    fill(left, 90 * 90);
    fill(right, 90 * 70);
    product_f64_65x90_90x70(left, right, result);
    if (!inverse_f64_100(a, &a_work) || !inverse_f32_50(b, &b_work)
        || !solve_f64_90x50(left, right, &solve_work)) {
        return 1;
    }
    print(a, 10000);
    for (int index = 0; index < 2500; index++) {
        uint32_t word;
        memcpy(&word, &b[index], sizeof word);
        printf("%" PRIu32 "\n", word);
    }
    print(right, 90 * 50);
    print(result, 65 * 70);
    return 0;
}
