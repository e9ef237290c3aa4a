lanes_t held[$inner][DOWN];
#pragma GCC unroll 32
for (uint32_t k = 0U; k < $inner; k++) {
#pragma GCC unroll 8
    for (uint32_t down = 0U; down < DOWN; down++) {
        held[k][down] = *(const lanes_t *)&a[$rows * k + OFFSET(down)];
    }
}
#pragma GCC unroll $unrolled
for (uint32_t column = 0U; column < $columns; column++) {
    lanes_t sums[DOWN];
#pragma GCC unroll 8
    for (uint32_t down = 0U; down < DOWN; down++) {
        sums[down] = TIMES(held[0][down], b[$held_first]);
    }
#pragma GCC unroll 32
    for (uint32_t k = 1U; k < $inner; k++) {
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
            sums[down] = PLUS(sums[down], held[k][down], b[$held_next]);
            IN_ITS_REGISTER(sums[down]);
        }
    }
#pragma GCC unroll 8
    for (uint32_t down = 0U; down < DOWN; down++) {
        *(lanes_t *)&result[$rows * column + OFFSET(down)] = sums[down];
    }
}
