$ends/* A term of each sum of a block. */
static inline __attribute__((always_inline)) void add_term(const $real *a, const $real *b, const uint32_t k,
    lanes_t sums[][VECTORS], const uint32_t columns, const uint32_t vectors)
{
    lanes_t rows[VECTORS];
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < vectors; vector++) {
        rows[vector] = $next_rows;
        IN_ITS_REGISTER(rows[vector]);
    }
#pragma GCC unroll 8
    for (uint32_t column = 0U; column < columns; column++) {
        const $real number = b[$next_number];
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < vectors; vector++) {
            sums[column][vector] = PLUS(sums[column][vector], rows[vector], number);
            IN_ITS_REGISTER(sums[column][vector]);
        }
    }
}

/* A block of the result, so many columns of so many vectors of rows: the first products, then the others in order. */
static inline __attribute__((always_inline)) void block(const $real *a, const $real *b, $real *result,
    const uint32_t columns, const uint32_t vectors)
{
    lanes_t sums[$widest][VECTORS];
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < vectors; vector++) {
        const lanes_t rows = $first_rows;
#pragma GCC unroll 8
        for (uint32_t column = 0U; column < columns; column++) {
            sums[column][vector] = TIMES(rows, b[$first_number]);
        }
    }
$terms_in_order#pragma GCC unroll 8
    for (uint32_t column = 0U; column < columns; column++) {
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < vectors; vector++) {
            *(lanes_t *)&result[$rows * column + OFFSET(vector)] = sums[column][vector];
        }
    }
}

/* So many vectors of rows: blocks of so many columns, and one of those that are left. */
static inline __attribute__((always_inline)) void band(const $real *a, const $real *b, $real *result,
    const uint32_t columns, const uint32_t vectors$shared)
{
$left_columns    for (uint32_t column = $begin; column < whole; column += $apart_columns) {
        block(a, &b[$at_column], &result[$rows * column], columns, vectors);
    }
$beside}
