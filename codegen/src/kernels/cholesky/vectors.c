#define DOWN (4U / LANES)

typedef $real lanes_t __attribute__((vector_size($bytes * LANES), aligned($bytes), may_alias));

/* Takes the known columns on the left from a tile. Then, unless it is the one of the diagonal, solves
   by that. */
static void take($real *tile, const $real *rows, const $real *columns, uint32_t known, const $real *top)
{
    lanes_t sums[4][DOWN];
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < 4U; column++) {
#pragma GCC unroll 2
        for (uint32_t down = 0U; down < DOWN; down++) {
            sums[column][down] = *(const lanes_t *)&tile[$n * column + LANES * down];
        }
    }
    for (; known > 0U; known--) {
#pragma GCC unroll 2
        for (uint32_t down = 0U; down < DOWN; down++) {
            const lanes_t four = *(const lanes_t *)&rows[LANES * down];
#pragma GCC unroll 4
            for (uint32_t column = 0U; column < 4U; column++) {
                sums[column][down] -= four * columns[column];
            }
        }
        rows += $n;
        columns += $n;
    }
    if (top != tile) {
#pragma GCC unroll 4
        for (uint32_t column = 0U; column < 4U; column++) {
#pragma GCC unroll 4
            for (uint32_t k = 0U; k < column; k++) {
#pragma GCC unroll 2
                for (uint32_t down = 0U; down < DOWN; down++) {
                    sums[column][down] -= sums[k][down] * top[column + $n * k];
                }
            }
#pragma GCC unroll 2
            for (uint32_t down = 0U; down < DOWN; down++) {
                sums[column][down] /= top[column + $n * column];
            }
        }
    }
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < 4U; column++) {
#pragma GCC unroll 2
        for (uint32_t down = 0U; down < DOWN; down++) {
            *(lanes_t *)&tile[$n * column + LANES * down] = sums[column][down];
        }
    }
}
