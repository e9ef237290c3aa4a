/* Four rows of a panel. */
typedef struct {
    row_t a;
    row_t b;
    row_t c;
    row_t d;
} tile_t;

/* The matrix' rows of a tile. */
typedef struct {
    $real *a;
    $real *b;
    $real *c;
    $real *d;
} rows_t;

static inline tile_t load_tile(const $real *from)
{
    const tile_t tile = {load_row(from), load_row(&from[WIDTH]), load_row(&from[2U * WIDTH]),
        load_row(&from[3U * WIDTH])};
    return tile;
}

static inline void store_tile($real *to, const tile_t *tile)
{
    store_row(to, tile->a);
    store_row(&to[WIDTH], tile->b);
    store_row(&to[2U * WIDTH], tile->c);
    store_row(&to[3U * WIDTH], tile->d);
}

static inline rows_t find_rows(const elimination_t *work, uint32_t row)
{
    const rows_t of = {
        at(work, row, 0U), at(work, row + 1U, 0U), at(work, row + 2U, 0U), at(work, row + 3U, 0U)};
    return of;
}

/* As HOLD, of all rows at once. */
#define HOLD_TILE(tile) __asm__("" : "+v"((tile)->a.low), "+v"((tile)->a.high), "+v"((tile)->b.low), "+v"((tile)->b.high), \
    "+v"((tile)->c.low), "+v"((tile)->c.high), "+v"((tile)->d.low), "+v"((tile)->d.high))

#if defined(FAST)
#if !defined(PLUS)
#define PLUS(row, factor, other) ((row) + (factor) * (other))
#endif

/* row - (factor * other + next * following): of two steps, one waits for the last. */
static inline row_t minus_two(row_t row, $real factor, row_t other, $real next, row_t following)
{
    const row_t rest = {row.low - PLUS(factor * other.low, next, following.low),
        row.high - PLUS(factor * other.high, next, following.high)};
    return rest;
}

/* Takes two rows, times multipliers of each row of the tile, from the tile. */
static inline void two_steps(tile_t *tile, const rows_t *of, size_t column, const $real *rows)
{
    const row_t other = load_operand(rows);
    const row_t following = load_operand(&rows[WIDTH]);
    tile->a = minus_two(tile->a, of->a[column], other, of->a[column + 1U], following);
    tile->b = minus_two(tile->b, of->b[column], other, of->b[column + 1U], following);
    tile->c = minus_two(tile->c, of->c[column], other, of->c[column + 1U], following);
    tile->d = minus_two(tile->d, of->d[column], other, of->d[column + 1U], following);
    HOLD_TILE(tile);
}

/* The same of four columns, and as many rows. */
static inline void four_steps(tile_t *tile, const rows_t *of, size_t column, const $real *rows)
{
    two_steps(tile, of, column, rows);
    two_steps(tile, of, column + 2U, &rows[2U * WIDTH]);
}
#else
/* Takes a row, times a multiplier of each row of the tile, from the tile. */
static inline void step(tile_t *tile, const rows_t *of, size_t column, const $real *row)
{
    const row_t other = load_operand(row);
    tile->a = minus(tile->a, of->a[column], other);
    tile->b = minus(tile->b, of->b[column], other);
    tile->c = minus(tile->c, of->c[column], other);
    tile->d = minus(tile->d, of->d[column], other);
    HOLD_TILE(tile);
}

/* The same of four columns, and as many rows. */
static inline void four_steps(tile_t *tile, const rows_t *of, size_t column, const $real *rows)
{
    step(tile, of, column, rows);
    step(tile, of, column + 1U, &rows[WIDTH]);
    step(tile, of, column + 2U, &rows[2U * WIDTH]);
    step(tile, of, column + 3U, &rows[3U * WIDTH]);
}
#endif

/* The same of fours from one to another. */
static inline void steps(tile_t *tile, const rows_t *of, size_t column, size_t end, const $real *rows)
{
    for (; column < end; column += 4U) {
        four_steps(tile, of, column, rows);
        rows += 4U * WIDTH;
    }
}

/* The steps of a tile's own rows: each is taken from those below it. */
static inline void own_steps(tile_t *tile, const rows_t *of, size_t column)
{
    tile->b = minus(tile->b, of->b[column], tile->a);
    tile->c = minus(tile->c, of->c[column], tile->a);
    tile->d = minus(tile->d, of->d[column], tile->a);
    tile->c = minus(tile->c, of->c[column + 1U], tile->b);
    tile->d = minus(tile->d, of->d[column + 1U], tile->b);
    tile->d = minus(tile->d, of->d[column + 2U], tile->c);
}

/* Takes the columns on the left of a panel, times the panel's rows, from its rows above the diagonal. Each has as many
   columns as there are rows above it, and is then done with: a row of the matrix. */
NOT_INLINE static void subtract_above(const elimination_t *work, uint32_t first)
{
    for (uint32_t row = 0U; row < first; row += 4U) {
        const rows_t of = find_rows(work, row);
        $real *const to = &work->panel[WIDTH * row];
        tile_t tile = load_tile(to);
        steps(&tile, &of, 0U, row, work->panel);
        own_steps(&tile, &of, row);
        store_row(&of.a[first], tile.a);
        store_row(&of.b[first], tile.b);
        store_row(&of.c[first], tile.c);
        store_row(&of.d[first], tile.d);
        store_tile(to, &tile);
    }
}

#if defined(TWO_QUADS)
/* Four vectors, of a row each, become columns of the block. */
static inline void store_columns($real *to, half_t a, half_t b, half_t c, half_t d)
{
    const square_t low = {__builtin_shufflevector(a, a, 0, 1, 2, 3), __builtin_shufflevector(b, b, 0, 1, 2, 3),
        __builtin_shufflevector(c, c, 0, 1, 2, 3), __builtin_shufflevector(d, d, 0, 1, 2, 3)};
    const square_t high = {__builtin_shufflevector(a, a, 4, 5, 6, 7), __builtin_shufflevector(b, b, 4, 5, 6, 7),
        __builtin_shufflevector(c, c, 4, 5, 6, 7), __builtin_shufflevector(d, d, 4, 5, 6, 7)};
    store_square(to, &to[BLOCK], &to[2U * BLOCK], &to[3U * BLOCK], turned(low));
    store_square(&to[4U * BLOCK], &to[5U * BLOCK], &to[6U * BLOCK], &to[7U * BLOCK], turned(high));
}

/* A vector of what is in a row of the block. */
static inline half_t vector_across(const $real *from)
{
    const half_t across = {from[0], from[BLOCK], from[2U * BLOCK], from[3U * BLOCK],
        from[4U * BLOCK], from[5U * BLOCK], from[6U * BLOCK], from[7U * BLOCK]};
    return across;
}
#else
/* Four vectors, of a row each, become columns of the block. */
static inline void store_columns($real *to, half_t a, half_t b, half_t c, half_t d)
{
    const square_t square = {a, b, c, d};
    store_square(to, &to[BLOCK], &to[2U * BLOCK], &to[3U * BLOCK], turned(square));
}

/* A vector of what is in a row of the block. */
static inline half_t vector_across(const $real *from)
{
    const half_t across = {from[0], from[BLOCK], from[2U * BLOCK], from[3U * BLOCK]};
    return across;
}
#endif

/* The same of the rows from the diagonal down, which become columns of the block. */
NOT_INLINE static void subtract_below(const elimination_t *work, uint32_t first)
{
    for (uint32_t row = first; row < ROWS; row += 4U) {
        const rows_t of = find_rows(work, row);
        $real *const to = &work->block[row - first];
        tile_t tile = load_tile(&work->panel[WIDTH * row]);
        steps(&tile, &of, 0U, first, work->panel);
        store_columns(to, tile.a.low, tile.b.low, tile.c.low, tile.d.low);
        store_columns(&to[HALF * BLOCK], tile.a.high, tile.b.high, tile.c.high, tile.d.high);
    }
}
