/* The inverse, whose columns are in the order of the pivots. */
static inline void give_rows($real *a, const $real *rows, const uint32_t *order)
{
    for (uint32_t to = 0U; to < $n; to += SIDE) {
        const uint32_t column = corner(to);
        for (uint32_t from = 0U; from < $n; from += SIDE) {
            const uint32_t row = corner(from);
            $real square[SIDE * SIDE];
            transpose_square(&rows[PITCH * row + column], PITCH, square, SIDE);
            for (uint32_t lane = 0U; lane < SIDE; lane++) {
                *(side_t *)&a[row + $n * order[column + lane]] = *(const side_t *)&square[SIDE * lane];
            }
        }
    }
}

