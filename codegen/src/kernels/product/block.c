/* A block of the result, vectors of rows by columns: the first products, then the others in order. */
static inline void block(const $real *a, const $real *b, $real *result)
{
    lanes_t sums[ACROSS][DOWN];
    /* What is used again stays in registers: the rows, or the numbers where they are fewer. */
#pragma GCC unroll 8
    for (uint32_t down = 0U; down < DOWN; down++) {
        const lanes_t rows = $first_rows;
#pragma GCC unroll 8
        for (uint32_t across = 0U; across < ACROSS; across++) {
            sums[across][down] = TIMES(rows, b[$first_number]);
        }
    }
$rolled    for (uint32_t k = 1U; k < $inner; k++) {
#if DOWN > ACROSS
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
            const lanes_t rows = $next_rows;
#pragma GCC unroll 8
            for (uint32_t across = 0U; across < ACROSS; across++) {
                sums[across][down] = PLUS(sums[across][down], rows, b[$next_number]);
            }
        }
#else
        lanes_t rows[DOWN];
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
            rows[down] = $next_rows;
        }
#pragma GCC unroll 8
        for (uint32_t across = 0U; across < ACROSS; across++) {
            const $real number = b[$next_number];
#pragma GCC unroll 8
            for (uint32_t down = 0U; down < DOWN; down++) {
                sums[across][down] = PLUS(sums[across][down], rows[down], number);
            }
        }
#endif
    }
#pragma GCC unroll 8
    for (uint32_t across = 0U; across < ACROSS; across++) {
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
            *(lanes_t *)&result[$rows * across + OFFSET(down)] = sums[across][down];
        }
    }
}
