#define VECTORS (4U / LANES)

typedef $real lanes_t __attribute__((vector_size($bytes * LANES), aligned($bytes), may_alias));

/* Takes the known columns on the left from a tile. Then, unless it is the one of the diagonal, solves
   by that. */
static void take($real *tile, const $real *rows, const $real *columns, uint32_t known, const $real *top)
{
    lanes_t sums[4][VECTORS];
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < 4U; column++) {
#pragma GCC unroll 2
        for (uint32_t vector = 0U; vector < VECTORS; vector++) {
            sums[column][vector] = *(const lanes_t *)&tile[$n * column + LANES * vector];
        }
    }
    for (; known > 0U; known--) {
#pragma GCC unroll 2
        for (uint32_t vector = 0U; vector < VECTORS; vector++) {
            const lanes_t four = *(const lanes_t *)&rows[LANES * vector];
#pragma GCC unroll 4
            for (uint32_t column = 0U; column < 4U; column++) {
                sums[column][vector] -= four * columns[column];
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
                for (uint32_t vector = 0U; vector < VECTORS; vector++) {
                    sums[column][vector] -= sums[k][vector] * top[column + $n * k];
                }
            }
#pragma GCC unroll 2
            for (uint32_t vector = 0U; vector < VECTORS; vector++) {
                sums[column][vector] /= top[column + $n * column];
            }
        }
    }
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < 4U; column++) {
#pragma GCC unroll 2
        for (uint32_t vector = 0U; vector < VECTORS; vector++) {
            *(lanes_t *)&tile[$n * column + LANES * vector] = sums[column][vector];
        }
    }
}
