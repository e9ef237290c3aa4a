/* The C of tests/corpus/src/programs/data/two_dimensional_arrays.rs. Written by a test. */

/* two_dimensional_arrays.c */

bessemer_status_t two_dimensional_arrays_smoothed(const float heights[4][5], uint64_t row,
    uint64_t column, float *BESSEMER_RESTRICT result)
{
    if (row < UINT64_C(1) || row > UINT64_C(2) || column < UINT64_C(1) || column > UINT64_C(3)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    const float sum = heights[row - UINT64_C(1)][column] + heights[row + UINT64_C(1)][column]
        + heights[row][column - UINT64_C(1)] + heights[row][column + UINT64_C(1)];
    *result = sum / 4.0F;
    return BESSEMER_STATUS_OK;
}
