static inline row_t over(row_t row, $real divisor)
{
#if defined(HALF)
    const row_t quotient = {row.low / divisor, row.high / divisor};
#else
    const row_t quotient = {row.a / divisor, row.b / divisor, row.c / divisor, row.d / divisor};
#endif
    return quotient;
}

/* Solves by U within a tile, from its last row upwards. */
static inline void divide(tile_t *tile, const $real *triangle)
{
    tile->r3 = over(tile->r3, triangle[15]);
    tile->r2 = minus(tile->r2, triangle[14], tile->r3);
    tile->r1 = minus(tile->r1, triangle[13], tile->r3);
    tile->r0 = minus(tile->r0, triangle[12], tile->r3);
    tile->r2 = over(tile->r2, triangle[10]);
    tile->r1 = minus(tile->r1, triangle[9], tile->r2);
    tile->r0 = minus(tile->r0, triangle[8], tile->r2);
    tile->r1 = over(tile->r1, triangle[5]);
    tile->r0 = minus(tile->r0, triangle[4], tile->r1);
    tile->r0 = over(tile->r0, triangle[0]);
}

NOT_INLINE static void divide_tile($real *to, const $real *from, const $real *triangle)
{
    tile_t tile = load_tile(from);
    divide(&tile, triangle);
    store_tile(to, &tile);
}

/* Takes columns of U, times rows of the panel, from a tile: from the last column and row backwards. */
NOT_INLINE static void subtract_backwards($real *to, const $real *from, const $real *columns,
    const $real *rows, uint32_t fours)
{
    tile_t tile = load_tile(from);
    uint32_t until_next = WIDTH / 4U;
#if defined(WORDS)
    int32_t four = -4;
    APART(four);
    do {
        step(&tile, columns, rows);
        columns += four;
        rows += four;
        APART(columns);
        APART(rows);
        step(&tile, columns, rows);
        columns += four;
        rows += four;
        APART(columns);
        APART(rows);
        step(&tile, columns, rows);
        columns += four;
        rows += four;
        APART(columns);
        APART(rows);
        step(&tile, columns, rows);
        columns += four;
        rows += four;
        APART(columns);
        APART(rows);
#else
    do {
        step(&tile, columns, rows);
        step(&tile, columns - 4, rows - WIDTH);
        step(&tile, columns - 8, rows - 2U * WIDTH);
        step(&tile, columns - 12, rows - 3U * WIDTH);
        columns -= 16;
        rows -= 4U * WIDTH;
        APART(columns);
        APART(rows);
#endif
        until_next--;
        if (WIDTH == 4U || until_next == 0U) {
            columns -= PANEL - TILE;
            until_next = WIDTH / 4U;
        }
        fours--;
    } while (fours > 0U);
    store_tile(to, &tile);
}

/* Solves for a panel of right-hand sides, in place. Above row `first` they are zero; `rest` is a tile of
   zeros that stands for what is below row `filled`. */
NOT_INLINE static void solve_panel(const $real *tiles, $real *panel, uint32_t first, uint32_t filled,
    const $real *rest)
{
    const uint32_t until_next = (WIDTH - (first + BEFORE) % WIDTH) / 4U;
    for (uint32_t row = first; row < ROWS; row += 4U) {
        $real *const tile = &panel[WIDTH * row];
        subtract(tile, (row < filled) ? tile : rest, &tiles[place(row, first)], &panel[WIDTH * first],
            (row - first) / 4U, until_next, &tiles[place(row, row)]);
    }
$pad_rows    for (uint32_t below = ROWS; below > 0U; below -= 4U) {
        const uint32_t row = below - 4U;
        $real *const tile = &panel[WIDTH * row];
        const $real *from = (row < first) ? rest : tile;
        if (below < ROWS) {
            subtract_backwards(tile, from, &tiles[place(row, ROWS - 4U) + 12U],
                &panel[WIDTH * (ROWS - 1U)], (ROWS - below) / 4U);
            from = tile;
        }
        divide_tile(tile, from, &tiles[place(row, row)]);
    }
}
