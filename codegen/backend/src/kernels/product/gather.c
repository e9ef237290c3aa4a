
/* Rows of a transposed factor, which lie apart. */
static inline lanes_t gather(const $real *a)
{
    lanes_t rows;
#pragma GCC unroll 16
    for (uint32_t lane = 0U; lane < LANES; lane++) {
        rows[lane] = a[$apart * lane];
    }
    return rows;
}
