/* Prints the words of solutions, and of what else these kernels give. */
#include "cholesky_f64_8.h"
#include "cholesky_solve_f64_8.h"
#include "inverse_f64_12.h"
#include "product_tr_f64_6x6_6x6.h"
#include "solve_f64_150.h"
#include "solve_f64_17.h"
#include "solve_f64_6.h"
#include "tr_product_f64_6x6_6x6.h"

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
    static double a[22500], x[150], inverse[144], factor[64], product[36];
    static solve_f64_150_work_t large;
    static solve_f64_17_work_t small;
    static solve_f64_6_work_t least;
    static inverse_f64_12_work_t work;
    uint64_t state = UINT64_C(88172645463325252);
    for (int index = 0; index < 22500; index++) {
        a[index] = next(&state);
    }
    for (int index = 0; index < 150; index++) {
        x[index] = next(&state);
    }
    memcpy(inverse, a, sizeof inverse);
    for (int index = 0; index < 64; index++) {
        factor[index] = a[index] + a[8 * (index % 8) + index / 8] + ((index % 9 == 0) ? 8.0 : 0.0);
    }
    print(a, 22500);
    print(x, 150);
    if (!solve_f64_150(a, x, &large)) {
        return 1;
    }
    print(x, 150);
    if (!solve_f64_17(a, x, &small) || !inverse_f64_12(inverse, &work) || !cholesky_f64_8(factor)) {
        return 1;
    }
    print(x, 17);
    print(inverse, 144);
    print(factor, 64);
    cholesky_solve_f64_8(factor, &x[20]);
    print(&x[20], 8);
    if (!solve_f64_6(&a[60], &x[30], &least)) {
        return 1;
    }
    print(&x[30], 6);
    product_tr_f64_6x6_6x6(a, &a[36], product);
    print(product, 36);
    tr_product_f64_6x6_6x6(a, &a[36], product);
    print(product, 36);
    return 0;
}
