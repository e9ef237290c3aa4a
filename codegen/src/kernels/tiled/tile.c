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
