typedef int32_t words_t __attribute__((vector_size(16), aligned(4), may_alias));

$last_row/* A part of a column of the result, in vectors of rows: the first products, then the others in order. Numbers
   that follow one another are loaded at once and spread from there: as integers, whose shuffle copies nothing. */
static inline void column_part(const $real *a, const $real *b, $real *result)
{
    lanes_t sums[VECTORS];
    words_t numbers = *(const words_t *)b;
    IN_ITS_REGISTER(numbers);
    lanes_t number = $spread_0;
#pragma GCC unroll 16
    for (uint32_t vector = 0U; vector < VECTORS; vector++) {
        sums[vector] = *(const lanes_t *)&a[OFFSET(vector)] * number;
    }
$last_first$first_group#pragma GCC unroll $terms
    for (uint32_t k = NUMBERS_AT_ONCE; k + NUMBERS_AT_ONCE <= $inner; k += NUMBERS_AT_ONCE) {
        numbers = *(const words_t *)&b[k];
        IN_ITS_REGISTER(numbers);
$in_turn$group    }
$last#pragma GCC unroll 16
    for (uint32_t vector = 0U; vector < VECTORS; vector++) {
        *(lanes_t *)&result[OFFSET(vector)] = sums[vector];
    }
$last_stored}
