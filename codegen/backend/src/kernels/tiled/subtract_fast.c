/* Two columns into two sums: a fused step waits for the one before it. */
static inline void two_steps(tile_t *even, tile_t *odd, const $real **columns, const $real **rows, size_t on)
{
    const $real *column = *columns;
    const $real *row = *rows;
    step(even, column, row);
    column += 4;
    row += WIDTH;
    APART(column);
    APART(row);
    step(odd, column, row);
    column += on;
    row += WIDTH;
    APART(column);
    APART(row);
    *columns = column;
    *rows = row;
}

static inline row_t sum(row_t row, row_t other)
{
    const row_t both = {row.low + other.low, row.high + other.high};
    return both;
}

/* Takes columns of the tiles on the left, times rows of the panel, from a tile: four columns at a time,
   and so many fours until the next panel. Then, if there is a triangle, solves by it within the tile. */
NOT_INLINE static void subtract($real *to, const $real *from, const $real *columns, const $real *rows,
    uint32_t fours, uint32_t until_next, const $real *triangle)
{
    const half_t zeros = {$zero};
    const row_t nothing = {zeros, zeros};
    tile_t odd = {nothing, nothing, nothing, nothing};
    tile_t tile = load_tile(from);
    for (; fours > 0U; fours--) {
        until_next--;
        two_steps(&tile, &odd, &columns, &rows, 4U);
        two_steps(&tile, &odd, &columns, &rows, 4U);
        if (until_next == 0U) {
            columns += PANEL - TILE;
            until_next = WIDTH / 4U;
        }
    }
    tile.r0 = sum(tile.r0, odd.r0);
    tile.r1 = sum(tile.r1, odd.r1);
    tile.r2 = sum(tile.r2, odd.r2);
    tile.r3 = sum(tile.r3, odd.r3);
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
