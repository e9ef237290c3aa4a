/* The rows of a block; the last vector overlaps where they are no multiple of its lanes. */
#define HEIGHT ((LANES * DOWN < $rows) ? LANES * DOWN : $rows)
#define OFFSET(vector) ((LANES * (vector) + LANES <= HEIGHT) ? LANES * (vector) : HEIGHT - LANES)

#if !defined(PLUS)
#define TIMES(rows, number) ((rows) * (number))
#define PLUS(sum, rows, number) ((sum) + (rows) * (number))
#endif

typedef $real lanes_t __attribute__((vector_size($bytes * LANES), aligned($bytes), may_alias));
$gather
/* A block of the result, vectors of rows by columns: the first products, then the others in order. */
static inline void block(const $real *a, const $real *b, $real *result)
{
    lanes_t sums[ACROSS][DOWN];
#pragma GCC unroll 8
    for (uint32_t down = 0U; down < DOWN; down++) {
        const lanes_t rows = $first_rows;
#pragma GCC unroll 8
        for (uint32_t across = 0U; across < ACROSS; across++) {
            sums[across][down] = TIMES(rows, b[$first_number]);
        }
    }
$rolled    for (uint32_t k = 1U; k < $inner; k++) {
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
            const lanes_t rows = $next_rows;
#pragma GCC unroll 8
            for (uint32_t across = 0U; across < ACROSS; across++) {
                sums[across][down] = PLUS(sums[across][down], rows, b[$next_number]);
            }
        }
    }
#pragma GCC unroll 8
    for (uint32_t across = 0U; across < ACROSS; across++) {
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
            *(lanes_t *)&result[$rows * across + OFFSET(down)] = sums[across][down];
        }
    }
}
