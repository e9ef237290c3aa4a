lanes_t held[$inner][VECTORS];
#pragma GCC unroll 32
for (uint32_t k = 0U; k < $inner; k++) {
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < VECTORS; vector++) {
        held[k][vector] = *(const lanes_t *)&a[$rows * k + OFFSET(vector)];
    }
}
#pragma GCC unroll $unrolled
for (uint32_t column = 0U; column < $columns; column++) {
    lanes_t sums[VECTORS];
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < VECTORS; vector++) {
        sums[vector] = TIMES(held[0][vector], b[$held_first]);
    }
#pragma GCC unroll 32
    for (uint32_t k = 1U; k < $inner; k++) {
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < VECTORS; vector++) {
            sums[vector] = PLUS(sums[vector], held[k][vector], b[$held_next]);
            IN_ITS_REGISTER(sums[vector]);
        }
    }
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < VECTORS; vector++) {
        *(lanes_t *)&result[$rows * column + OFFSET(vector)] = sums[vector];
    }
}
