/* A product of the user's own, in the order of the kernel: so its bits are the same. */
#ifndef OWN_PRODUCT_H
#define OWN_PRODUCT_H

#include <stdint.h>

void own_product(uint32_t rows, uint32_t inner, uint32_t columns, const float *a, const float *b,
    float *result);

#endif
