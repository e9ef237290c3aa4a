/* Elements of the last row, which fill no vector: the first products, then the others in order. */
static inline void last_row(const $real *a, const $real *b, $real *result)
{
    $real sums[LAST_ROW_COLUMNS];
#pragma GCC unroll 32
    for (uint32_t column = 0U; column < LAST_ROW_COLUMNS; column++) {
        sums[column] = a[0] * b[$first_number];
    }
$alone_unrolled    for (uint32_t k = 1U; k < $inner; k++) {
#pragma GCC unroll 32
        for (uint32_t column = 0U; column < LAST_ROW_COLUMNS; column++) {
            sums[column] += a[$next_a] * b[$next_number];
            IN_ITS_REGISTER(sums[column]);
        }
    }
#pragma GCC unroll 32
    for (uint32_t column = 0U; column < LAST_ROW_COLUMNS; column++) {
        result[$rows * column] = sums[column];
    }
}
