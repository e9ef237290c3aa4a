#include "own_product.h"

void own_product(uint32_t rows, uint32_t inner, uint32_t columns, const float *a, const float *b,
    float *result)
{
    for (uint32_t column = 0U; column < columns; column++) {
        for (uint32_t row = 0U; row < rows; row++) {
            float sum = a[row] * b[inner * column];
            for (uint32_t k = 1U; k < inner; k++) {
                sum += a[row + rows * k] * b[k + inner * column];
            }
            result[row + rows * column] = sum;
        }
    }
}
