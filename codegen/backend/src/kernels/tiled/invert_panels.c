/* Solves for panels of the identity, in the order of the pivots, and writes their columns of the inverse:
   the panel `from`, and every one so far apart. */
static void invert_panels(const $real *tiles, $real *a, const uint32_t *order, bool finite, $real *panel,
    uint32_t from, uint32_t apart)
{
    $real *const zeros = &panel[PANEL];
    for (uint32_t index = 0U; index < TILE; index++) {
        zeros[index] = $zero;
    }
    for (uint32_t begin = from; begin < PANELS; begin += apart) {
        const uint32_t first = (begin == 0U) ? 0U : begin * WIDTH - BEFORE;
        const uint32_t end = (begin + 1U) * WIDTH - BEFORE;
        /* A zero times a multiplier that is no number is no zero: then nothing is skipped. */
        const uint32_t known = finite ? first : 0U;
        for (uint32_t row = known; row < end; row++) {
            for (uint32_t lane = 0U; lane < WIDTH; lane++) {
                panel[WIDTH * row + lane] = (row + WIDTH == end + lane) ? $one : $zero;
            }
        }
        solve_panel(tiles, panel, known, end, zeros);
        for (uint32_t k = first; k < end && k < SIZE; k += 4U) {
            give_columns(a, &panel[k + WIDTH - end], &order[k]$fewer);
        }
    }
}
