/* Four columns, one after another; then the way on to the next four. */
#if defined(SINGLES)
static inline void four_steps(tile_t *tile, const $real **columns, const $real **rows, size_t on)
{
    step_on(tile, columns, rows);
    step_on(tile, columns, rows);
    step_on(tile, columns, rows);
    step_on(tile, columns, rows);
    *columns += on - 4U;
}
#else
static inline void four_steps(tile_t *tile, const $real **columns, const $real **rows, size_t on)
{
    const $real *column = *columns;
    const $real *row = *rows;
    step(tile, column, row);
    column += 4;
    row += WIDTH;
    APART(column);
    APART(row);
    step(tile, column, row);
    column += 4;
    row += WIDTH;
    APART(column);
    APART(row);
    step(tile, column, row);
    column += 4;
    row += WIDTH;
    APART(column);
    APART(row);
    step(tile, column, row);
    column += on;
    row += WIDTH;
    APART(column);
    APART(row);
    *columns = column;
    *rows = row;
}
#endif

/* Takes columns of the tiles on the left, times rows of the panel, from a tile: four columns at a time,
   and so many fours until the next panel. Then, if there is a triangle, solves by it within the tile. */
NOT_INLINE static void subtract($real *to, const $real *from, const $real *columns, const $real *rows,
    uint32_t fours, uint32_t until_next, const $real *triangle)
{
    tile_t tile = load_tile(from);
#if defined(LOAD_MULTIPLE)
    /* A distance in a register: loads step by it. */
    (void)until_next;
    size_t on = PANEL - TILE + 4U;
    APART(on);
    for (; fours > 0U; fours--) {
        four_steps(&tile, &columns, &rows, on);
    }
#elif WIDTH == 4U
    /* Two fours at a time: fewer jumps. */
    (void)until_next;
    if (fours % 2U == 1U) {
        four_steps(&tile, &columns, &rows, PANEL - TILE + 4U);
    }
    for (fours /= 2U; fours > 0U; fours--) {
        four_steps(&tile, &columns, &rows, PANEL - TILE + 4U);
        four_steps(&tile, &columns, &rows, PANEL - TILE + 4U);
    }
#else
    for (; fours > 0U; fours--) {
        until_next--;
        four_steps(&tile, &columns, &rows, 4U);
        if (until_next == 0U) {
            columns += PANEL - TILE;
            until_next = WIDTH / 4U;
        }
    }
#endif
    if (triangle != NULL) {
        tile.r1 = minus(tile.r1, triangle[1], tile.r0);
        tile.r2 = minus(tile.r2, triangle[2], tile.r0);
        tile.r3 = minus(tile.r3, triangle[3], tile.r0);
        tile.r2 = minus(tile.r2, triangle[6], tile.r1);
        tile.r3 = minus(tile.r3, triangle[7], tile.r1);
        tile.r3 = minus(tile.r3, triangle[11], tile.r2);
    }
    store_tile(to, &tile);
}
