/* Rows of a tile. */
typedef struct {
    row_t r0;
    row_t r1;
    row_t r2;
    row_t r3;
} tile_t;

static inline tile_t load_tile(const $real *from)
{
    const tile_t tile = {load_row(from), load_row(&from[WIDTH]), load_row(&from[2U * WIDTH]),
        load_row(&from[3U * WIDTH])};
    return tile;
}

static inline void store_tile($real *to, const tile_t *tile)
{
    store_row(to, tile->r0);
    store_row(&to[WIDTH], tile->r1);
    store_row(&to[2U * WIDTH], tile->r2);
    store_row(&to[3U * WIDTH], tile->r3);
}

/* Takes a row, times the four multipliers of a column, from the rows of the tile. */
static inline void step(tile_t *tile, const $real *column, const $real *row)
{
#if defined(WORDS) || defined(HALF)
    const four_t factor = load_four(column);
    const row_t other = load_operand(row);
    tile->r0 = minus(tile->r0, factor.a, other);
    tile->r1 = minus(tile->r1, factor.b, other);
    tile->r2 = minus(tile->r2, factor.c, other);
    tile->r3 = minus(tile->r3, factor.d, other);
#else
    const row_t other = load_row(row);
    tile->r0 = minus(tile->r0, column[0], other);
    tile->r1 = minus(tile->r1, column[1], other);
    tile->r2 = minus(tile->r2, column[2], other);
    tile->r3 = minus(tile->r3, column[3], other);
#endif
}

/*
 * A panel is WIDTH columns of a matrix, row by row. Done with, it is kept in tiles: four rows of a panel,
 * column by column. The first panel begins with BEFORE columns that do not exist.
 *
 * So an element sees its steps in their order: a tile is loaded, goes through all columns on its left
 * from the first to the last, and is stored once.
 */
#define TILE (4U * WIDTH)
#define PANEL (ROWS * WIDTH)
#define PANELS ((ROWS + WIDTH - 1U) / WIDTH)
#define BEFORE (WIDTH * PANELS - ROWS)

/* Where the four multipliers of a tile of rows and a column of the matrix are. */
static inline uint32_t place(uint32_t row, uint32_t column)
{
    const uint32_t lane = column + BEFORE;
    return PANEL * (lane / WIDTH) + WIDTH * row + 4U * (lane % WIDTH);
}

/* Four columns, one after another; then the way on to the next four. */
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

/* Takes columns of the tiles on the left, times rows of the panel, from a tile: four columns at a time,
   and so many fours until the next panel. Then, if there is a triangle, solves by it within the tile. */
NOT_INLINE static void subtract($real *to, const $real *from, const $real *columns, const $real *rows,
    uint32_t fours, uint32_t until_next, const $real *triangle)
{
    tile_t tile = load_tile(from);
#if defined(WORDS)
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
