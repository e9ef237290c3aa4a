/*
 * Inputs of the jobs on the Cortex-M4F, equal for each contender.
 */
#ifndef DSP_INPUTS_H
#define DSP_INPUTS_H

#include "dsp.h"

enum { BLOCK = 64, SECTIONS = 4, TAPS = 32, PERIODS = 3 };

/* A stable section: b0, b1, b2, a1, a2, with feedback that is added. */
static inline void fill_sections(float coefficients[5 * SECTIONS])
{
    for (size_t i = 0; i < SECTIONS; i++) {
        const float shift = 0.05f * (float)i;
        coefficients[5 * i] = 0.2f + shift;
        coefficients[5 * i + 1] = 0.3f;
        coefficients[5 * i + 2] = 0.1f + shift;
        coefficients[5 * i + 3] = 0.9f - shift;
        coefficients[5 * i + 4] = -0.4f + shift;
    }
}

/* Numbers, and on the diagonal the size more, symmetric on request. */
static inline void fill_matrix(float *matrix, size_t n, uint32_t seed, int symmetric)
{
    fill(matrix, n * n, seed);
    for (size_t column = 0; column < n; column++) {
        for (size_t row = 0; symmetric && row < column; row++) {
            matrix[row + n * column] = matrix[column + n * row];
        }
        matrix[column + n * column] += (float)n;
    }
}

#endif
