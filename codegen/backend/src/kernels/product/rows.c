$ends/* A band of the result, vectors of rows below one another: the first products, then the others in order. */
static inline __attribute__((always_inline)) void band(const $real *a, const $real *b, $real *result,
    const uint32_t vectors)
{
    lanes_t sums[VECTORS];
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < vectors; vector++) {
        sums[vector] = TIMES($first_rows, b[0]);
    }
$unrolled_terms    for (uint32_t k = 1U; k < $inner; k++) {
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < vectors; vector++) {
            sums[vector] = PLUS(sums[vector], $next_rows, b[$next_b]);
            IN_ITS_REGISTER(sums[vector]);
        }
    }
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < vectors; vector++) {
        *(lanes_t *)&result[OFFSET(vector)] = sums[vector];
    }
}
