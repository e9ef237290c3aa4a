/* The inverse, whose columns are in the order of the pivots: number by number, for most vectors would lie across
   two that are still on their way to memory. */
static inline void give_rows($real *a, const $real *rows, const uint32_t *order)
{
    for (uint32_t k = 0U; k < $n; k++) {
        $real *const column = &a[$n * order[k]];
#pragma GCC unroll 8
        for (uint32_t row = 0U; row < $n; row++) {
            column[row] = rows[PITCH * row + k];
        }
    }
}

