/* The C of tests/corpus/src/programs/functions/own_indices.rs. Written by a test. */

/* own_indices.c */

int32_t sides_index_side(const sides_t *self, side_t side)
{
    switch (side) {
    case SIDE_LEFT:
        return self->left;
    case SIDE_RIGHT:
    default:
        return self->right;
    }
}

bessemer_status_t own_indices_levelled(grid_t *BESSEMER_RESTRICT grid, uint64_t row,
    uint64_t column, double *BESSEMER_RESTRICT mean)
{
    if (column >= UINT64_C(4)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    if (row > UINT64_C(0x3FFFFFFFFFFFFFFF)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    const uint64_t mean_index = UINT64_C(4) * row + column;
    if (mean_index >= UINT64_C(12)) {
        return BESSEMER_STATUS_INDEX;
    }
    const uint64_t column_2 = column + UINT64_C(1);
    if (column_2 >= UINT64_C(4)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    const uint64_t heights_index = UINT64_C(4) * row + column_2;
    if (heights_index >= UINT64_C(12)) {
        return BESSEMER_STATUS_INDEX;
    }
    const double mean_value = 0.5 * (grid->heights[mean_index] + grid->heights[heights_index]);
    const uint64_t heights_index_2 = UINT64_C(4) * row + column;
    if (heights_index_2 >= UINT64_C(12)) {
        return BESSEMER_STATUS_INDEX;
    }
    grid->heights[heights_index_2] = mean_value;
    grid->heights[3] += mean_value;
    *mean = mean_value;
    return BESSEMER_STATUS_OK;
}

int32_t own_indices_difference(const sides_t *sides)
{
    return wrap_i32((uint32_t)sides_index_side(sides, SIDE_LEFT)
        - (uint32_t)sides_index_side(sides, SIDE_RIGHT));
}

/* own_indices.h */

/** Heights on a grid, row by row. */
typedef struct {
    double heights[12];
} grid_t;

/** Left or right. */
typedef enum {
    SIDE_LEFT = 0,
    SIDE_RIGHT = 1
} side_t;

/** A value for each side. */
typedef struct {
    int32_t left;
    int32_t right;
} sides_t;
