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
    for (uint32_t down = 0U; down < DOWN; down++) {
        rows[down] = *(const lanes_t *)&a[OFFSET(down)];
        IN_ITS_REGISTER(rows[down]);
    }
}

/* A term of each sum. */
static inline __attribute__((always_inline)) void add_beside(const $real *a, const words_t *numbers, const uint32_t next,
    lanes_t sums[][DOWN], const uint32_t beside)
{
    lanes_t rows[DOWN];
    load_rows(a, rows);
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < beside; column++) {
        const lanes_t number = spread(numbers[column], next);
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
$product            IN_ITS_REGISTER(sums[column][down]);
        }
    }
}

/* Columns of the result that lie side by side, in vectors of rows: the first products, then the others in order. */
static inline __attribute__((always_inline)) void columns_beside(const $real *a, const $real *b, $real *result,
    const uint32_t beside)
{
    lanes_t sums[$beside][DOWN];
    words_t numbers[$beside];
    load_numbers(b, numbers, beside);
    lanes_t rows[DOWN];
    load_rows(a, rows);
#pragma GCC unroll 4
    for (uint32_t column = 0U; column < beside; column++) {
        const lanes_t number = spread(numbers[column], 0U);
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
            sums[column][down] = rows[down] * number;
            IN_ITS_REGISTER(sums[column][down]);
        }
    }
#pragma GCC unroll 4
    for (uint32_t next = 1U; next < TOGETHER; next++) {
        add_beside(&a[$rows * next], numbers, next, sums, beside);
    }
#pragma GCC unroll $terms
    for (uint32_t k = TOGETHER; k + TOGETHER <= $inner; k += TOGETHER) {
        load_numbers(&b[k], numbers, beside);
#pragma GCC unroll 4
        for (uint32_t next = 0U; next < TOGETHER; next++) {
            add_beside(&a[$rows * (k + next)], numbers, next, sums, beside);
        }
    }
$rest#pragma GCC unroll 4
    for (uint32_t column = 0U; column < beside; column++) {
#pragma GCC unroll 8
        for (uint32_t down = 0U; down < DOWN; down++) {
            *(lanes_t *)&result[$rows * column + OFFSET(down)] = sums[column][down];
        }
    }
}
