/* Solves by the columns of a panel from the last one back, in the panel's own rows: the next one first, which is waited for. */
static inline void substitute_own(const elimination_t *work, uint32_t first, uint32_t columns)
{
    $real *const x = work->x;
    for (uint32_t column = first + columns; column > first; column--) {
        const uint32_t own = column - 1U;
        const $real number = x[own] $over *at(work, own, own);
        x[own] = number;
        for (uint32_t row = own; row > first; row--) {
            x[row - 1U] -= *at(work, row - 1U, own) * number;
        }
    }
}

static inline quad_lanes_t minus_quad(quad_lanes_t quad, $real factor, quad_lanes_t other)
{
    return quad - factor * other;
}

/* Solves by U. */
NOT_INLINE static void substitute(const elimination_t *work)
{
    $real *const x = work->x;
    uint32_t first = ROWS;
    while (first > 0U) {
        first = (first > WIDTH) ? first - WIDTH : 0U;
#if defined(EDGE)
        uint32_t columns = columns_from(first);
#else
        const uint32_t columns = columns_from(first);
#endif
        substitute_own(work, first, columns);
#if defined(EDGE)
        /* Columns at the end that are no four. */
        for (; columns % 4U != 0U; columns--) {
            const uint32_t column = first + columns - 1U;
            for (uint32_t row = 0U; row < first; row++) {
                x[row] -= *at(work, row, column) * x[column];
            }
        }
#endif
        for (uint32_t row = 0U; row < first; row += 4U) {
            quad_lanes_t four = load_quad(&x[row]);
            for (uint32_t end = first + columns; end > first; end -= 4U) {
                const uint32_t column = end - 4U;
                const square_t square = turned(load_square(at(work, row, column),
                    at(work, row + 1U, column), at(work, row + 2U, column), at(work, row + 3U, column)));
                four = minus_quad(four, x[column + 3U], square.d);
                four = minus_quad(four, x[column + 2U], square.c);
                four = minus_quad(four, x[column + 1U], square.b);
                four = minus_quad(four, x[column], square.a);
            }
            store_quad(&x[row], four);
        }
    }
}
