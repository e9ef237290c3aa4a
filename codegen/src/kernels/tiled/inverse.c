$real *const tiles = aligned(tile_memory);
$real *const panel = aligned(panel_memory);
bool finite = true;
if (!factor(a, tiles, panel, pivots, &finite)) {
    return false;
}
/* Right-hand sides in the order of the pivots: of row k, the column order[k] of the identity. */
for (uint32_t k = 0U; k < SIZE; k++) {
    order[k] = k;
}
for (uint32_t k = 0U; k < SIZE; k++) {
    const uint32_t column = order[k];
    order[k] = order[pivots[k]];
    order[pivots[k]] = column;
}
$real *const zeros = &panel[PANEL];
for (uint32_t index = 0U; index < TILE; index++) {
    zeros[index] = $zero;
}
for (uint32_t begin = 0U; begin < PANELS; begin++) {
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
return true;
