$ends/* A term of each sum of a block. */
static inline __attribute__((always_inline)) void add_term(const $real *a, const $real *b, const uint32_t k,
    lanes_t sums[][DOWN], const uint32_t across, const uint32_t down)
{
    lanes_t rows[DOWN];
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < down; vector++) {
        rows[vector] = $next_rows;
        IN_ITS_REGISTER(rows[vector]);
    }
#pragma GCC unroll 8
    for (uint32_t column = 0U; column < across; column++) {
        const $real number = b[$next_number];
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < down; vector++) {
            sums[column][vector] = PLUS(sums[column][vector], rows[vector], number);
            IN_ITS_REGISTER(sums[column][vector]);
        }
    }
}

/* A block of the result, so many columns of so many vectors of rows: the first products, then the others in order. */
static inline __attribute__((always_inline)) void block(const $real *a, const $real *b, $real *result,
    const uint32_t across, const uint32_t down)
{
    lanes_t sums[$widest][DOWN];
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < down; vector++) {
        const lanes_t rows = $first_rows;
#pragma GCC unroll 8
        for (uint32_t column = 0U; column < across; column++) {
            sums[column][vector] = TIMES(rows, b[$first_number]);
        }
    }
$terms_in_order#pragma GCC unroll 8
    for (uint32_t column = 0U; column < across; column++) {
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < down; vector++) {
            *(lanes_t *)&result[$rows * column + OFFSET(vector)] = sums[column][vector];
        }
    }
}

/* So many vectors of rows: blocks of so many columns, and one of those that are left. */
static inline __attribute__((always_inline)) void band(const $real *a, const $real *b, $real *result,
    const uint32_t across, const uint32_t down$shared)
{
$left_columns    for (uint32_t column = $begin; column < whole; column += $apart_columns) {
        block(a, &b[$at_column], &result[$rows * column], across, down);
    }
$beside}
