typedef int32_t words_t __attribute__((vector_size(16), aligned(4), may_alias));

/* Numbers that follow one another, of so many columns. */
static inline __attribute__((always_inline)) void load_numbers(const $real *b, words_t *numbers, const uint32_t beside)
{
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < beside; column++) {
        numbers[column] = *(const words_t *)&b[$inner * column];
        IN_ITS_REGISTER(numbers[column]);
    }
}

/* One of them in each lane: shuffled as integers, which copies nothing. */
static inline __attribute__((always_inline)) lanes_t spread(const words_t numbers, const uint32_t next)
{
    switch (next) {
$cases    }
}

/* The rows of a term. */
static inline __attribute__((always_inline)) void load_rows(const $real *a, lanes_t *rows)
{
#pragma GCC unroll 8
    for (uint32_t vector = 0U; vector < VECTORS; vector++) {
        rows[vector] = *(const lanes_t *)&a[OFFSET(vector)];
        IN_ITS_REGISTER(rows[vector]);
    }
}

/* A term of each sum. */
static inline __attribute__((always_inline)) void add_beside(const $real *a, const words_t *numbers, const uint32_t next,
    lanes_t sums[][VECTORS], const uint32_t beside)
{
    lanes_t rows[VECTORS];
    load_rows(a, rows);
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < beside; column++) {
        const lanes_t number = spread(numbers[column], next);
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < VECTORS; vector++) {
$product            IN_ITS_REGISTER(sums[column][vector]);
        }
    }
}

/* Columns of the result that lie side by side, in vectors of rows: the first products, then the others in order. */
static inline __attribute__((always_inline)) void columns_beside(const $real *a, const $real *b, $real *result,
    const uint32_t beside)
{
    lanes_t sums[$beside][VECTORS];
    words_t numbers[$beside];
    load_numbers(b, numbers, beside);
    lanes_t rows[VECTORS];
    load_rows(a, rows);
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < beside; column++) {
        const lanes_t number = spread(numbers[column], 0U);
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < VECTORS; vector++) {
            sums[column][vector] = rows[vector] * number;
            IN_ITS_REGISTER(sums[column][vector]);
        }
    }
#pragma GCC unroll 4
    for (uint32_t next = 1U; next < NUMBERS_AT_ONCE; next++) {
        add_beside(&a[$rows * next], numbers, next, sums, beside);
    }
#pragma GCC unroll $terms
    for (uint32_t k = NUMBERS_AT_ONCE; k + NUMBERS_AT_ONCE <= $inner; k += NUMBERS_AT_ONCE) {
        load_numbers(&b[k], numbers, beside);
#pragma GCC unroll 4
        for (uint32_t next = 0U; next < NUMBERS_AT_ONCE; next++) {
            add_beside(&a[$rows * (k + next)], numbers, next, sums, beside);
        }
    }
$rest#pragma GCC unroll 4
    for (uint32_t column = 0U; column < beside; column++) {
#pragma GCC unroll 8
        for (uint32_t vector = 0U; vector < VECTORS; vector++) {
            *(lanes_t *)&result[$rows * column + OFFSET(vector)] = sums[column][vector];
        }
    }
}
