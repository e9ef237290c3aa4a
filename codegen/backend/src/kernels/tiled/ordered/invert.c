/* Numbers of a panel of right-hand sides. */
#define PANEL (WIDTH * ROWS)

/* Right-hand sides: columns of the identity in the order of the pivots, in one panel or two. */
typedef struct {
    $real *panels;
    uint32_t count;
    /* The row above which the first panel is zero, and how many more are so in the second. */
    uint32_t first;
    uint32_t later;
    /* The row from which on they are zero to begin with, and a tile of zeros that is read there. */
    uint32_t filled;
    const $real *zeros;
} sides_t;

#if defined(EDGE)
/* What fills the last tiles up: rows of zeros, columns of the identity. */
static void pad(const elimination_t *work)
{
    for (uint32_t row = 0U; row < ROWS; row++) {
        for (uint32_t column = (row < SIZE) ? SIZE : 0U; column < ROWS; column++) {
            *at(work, row, column) = (row == column) ? $one : $zero;
        }
    }
}

#endif
/* Whether all multipliers are finite: with one that is not, every later number of its row is none, its pivot among them. */
static bool all_finite(const elimination_t *work)
{
    bool finite = true;
    for (uint32_t k = 0U; k < SIZE; k++) {
#if defined(FAST)
        /* Reciprocals. */
        finite = finite && isfinite(*at(work, k, k)) != 0 && *at(work, k, k) != $zero;
#else
        finite = finite && isfinite(*at(work, k, k)) != 0;
#endif
    }
    return finite;
}

/* Takes the columns of L on the left of a tile, from the first one on, times the rows above it, and solves by L within it. */
NOT_INLINE static void take_left(const elimination_t *work, $real *panel, uint32_t first, uint32_t row, const $real *from)
{
    const rows_t of = find_rows(work, row);
    tile_t tile = load_tile(from);
    steps(&tile, &of, first, row, &panel[WIDTH * first]);
    own_steps(&tile, &of, row);
    store_tile(&panel[WIDTH * row], &tile);
}

/* Solves by L. */
static void forward(const elimination_t *work, const sides_t *sides)
{
    for (uint32_t row = sides->first; row < ROWS; row += 4U) {
        for (uint32_t panel = 0U; panel < sides->count; panel++) {
            $real *const own = &sides->panels[PANEL * panel];
            const uint32_t first = sides->first + sides->later * panel;
            if (row >= first) {
                take_left(work, own, first, row, (row < sides->filled) ? &own[WIDTH * row] : sides->zeros);
            }
        }
    }
#if defined(EDGE)
    for (uint32_t panel = 0U; panel < sides->count; panel++) {
        for (uint32_t index = WIDTH * SIZE; index < PANEL; index++) {
            sides->panels[PANEL * panel + index] = $zero;
        }
    }
#endif
}

static inline row_t over(row_t row, $real divisor)
{
    const row_t quotient = {row.low $over divisor, row.high $over divisor};
    return quotient;
}

/* The last row of a tile is divided, and taken from those above it. */
static inline void divide_d(tile_t *tile, const rows_t *of, uint32_t column)
{
    tile->d = over(tile->d, of->d[column + 3U]);
    tile->c = minus(tile->c, of->c[column + 3U], tile->d);
    tile->b = minus(tile->b, of->b[column + 3U], tile->d);
    tile->a = minus(tile->a, of->a[column + 3U], tile->d);
}

/* The same of the third. */
static inline void divide_c(tile_t *tile, const rows_t *of, uint32_t column)
{
    tile->c = over(tile->c, of->c[column + 2U]);
    tile->b = minus(tile->b, of->b[column + 2U], tile->c);
    tile->a = minus(tile->a, of->a[column + 2U], tile->c);
}

/* The same of the other two. */
static inline void divide_b(tile_t *tile, const rows_t *of, uint32_t column)
{
    tile->b = over(tile->b, of->b[column + 1U]);
    tile->a = minus(tile->a, of->a[column + 1U], tile->b);
}

static inline void divide_a(tile_t *tile, const rows_t *of, uint32_t column)
{
    tile->a = over(tile->a, of->a[column]);
}

/* Four columns of U, from the last one back, times as many rows of a panel. */
static inline void four_steps_back(tile_t *tile, const rows_t *of, size_t column, const $real *panel)
{
    const $real *const rows = &panel[WIDTH * column];
#if defined(FAST)
    two_steps(tile, of, column + 2U, &rows[2U * WIDTH]);
    two_steps(tile, of, column, rows);
#else
    step(tile, of, column + 3U, &rows[3U * WIDTH]);
    step(tile, of, column + 2U, &rows[2U * WIDTH]);
    step(tile, of, column + 1U, &rows[WIDTH]);
    step(tile, of, column, rows);
#endif
}

/* Takes the columns of U on the right of a tile, times the rows below it, from the last one back. */
static inline tile_t right_taken(const rows_t *of, const $real *panel, uint32_t row, const $real *from)
{
    tile_t tile = load_tile(from);
    for (size_t column = ROWS - 4U; column > row; column -= 4U) {
        four_steps_back(&tile, of, column, panel);
    }
    return tile;
}

NOT_INLINE static void take_right(const elimination_t *work, $real *panel, uint32_t row, const $real *from)
{
    const rows_t of = find_rows(work, row);
    const tile_t tile = right_taken(&of, panel, row, from);
    store_tile(&panel[WIDTH * row], &tile);
}

/* Solves by U for a tile. */
NOT_INLINE static void solve_tile(const elimination_t *work, $real *panel, uint32_t row, const $real *from)
{
    const rows_t of = find_rows(work, row);
    tile_t tile = right_taken(&of, panel, row, from);
    divide_d(&tile, &of, row);
    divide_c(&tile, &of, row);
    divide_b(&tile, &of, row);
    divide_a(&tile, &of, row);
    store_tile(&panel[WIDTH * row], &tile);
}

/* The same, and within the tile of another panel, which has nothing on its right any more: side by side they share the time for
   which a quotient is waited. */
NOT_INLINE static void solve_tiles(const elimination_t *work, $real *panel, uint32_t row, const $real *from, $real *beside)
{
    const rows_t of = find_rows(work, row);
    tile_t tile = right_taken(&of, panel, row, from);
    tile_t other = load_tile(beside);
    divide_d(&tile, &of, row);
    divide_d(&other, &of, row);
    divide_c(&tile, &of, row);
    divide_c(&other, &of, row);
    divide_b(&tile, &of, row);
    divide_b(&other, &of, row);
    divide_a(&tile, &of, row);
    divide_a(&other, &of, row);
    store_tile(&panel[WIDTH * row], &tile);
    store_tile(beside, &other);
}

/* A tile of one of the panels, which is zero where the panel's first column is below it. */
static inline const $real *tile_of(const sides_t *sides, uint32_t panel, uint32_t row)
{
    const bool zero = row < sides->first + sides->later * panel;
    return zero ? sides->zeros : &sides->panels[PANEL * panel + WIDTH * row];
}

/* Solves by U. */
static void backward(const elimination_t *work, const sides_t *sides)
{
    $real *const panels = sides->panels;
    for (uint32_t below = ROWS; below > 0U; below -= 4U) {
        const uint32_t row = below - 4U;
        if (sides->count == 2U) {
            take_right(work, panels, row, tile_of(sides, 0U, row));
            solve_tiles(work, &panels[PANEL], row, tile_of(sides, 1U, row), &panels[WIDTH * row]);
        } else {
            solve_tile(work, panels, row, tile_of(sides, 0U, row));
        }
    }
}

/* Writes four columns of a panel, or so many, to their columns of the matrix. */
static void give_columns($real *a, const $real *panel, const uint32_t *order, uint32_t columns)
{
    uint32_t row = 0U;
    for (; columns == 4U && row + 4U <= SIZE; row += 4U) {
        const $real *const from = &panel[WIDTH * row];
        $real *const to = &a[row];
        store_square(&to[SIZE * order[0]], &to[SIZE * order[1]], &to[SIZE * order[2]], &to[SIZE * order[3]],
            turned(load_square(from, &from[WIDTH], &from[2U * WIDTH], &from[3U * WIDTH])));
    }
    for (; row < SIZE; row++) {
        for (uint32_t lane = 0U; lane < columns; lane++) {
            a[SIZE * order[lane] + row] = panel[WIDTH * row + lane];
        }
    }
}

/* Columns of the identity, as many as a panel has, from one on: its rows from one to another. */
static void fill_identity($real *panel, uint32_t first, uint32_t from, uint32_t end)
{
    for (uint32_t row = from; row < end; row++) {
        for (uint32_t lane = 0U; lane < WIDTH; lane++) {
            panel[WIDTH * row + lane] = (row == first + lane) ? $one : $zero;
        }
    }
}

/* Solves for pairs of panels of the identity, in the order of the pivots, and writes their columns of the inverse: the pair
   `from`, and every one so far apart. */
static void invert_panels(const elimination_t *work, $real *a, bool finite, $real *panels, uint32_t from, uint32_t apart)
{
    $real *const zeros = &panels[2U * PANEL];
    for (uint32_t index = 0U; index < 4U * WIDTH; index++) {
        zeros[index] = $zero;
    }
    for (uint32_t first = 2U * WIDTH * from; first < SIZE; first += 2U * WIDTH * apart) {
        const uint32_t count = (SIZE - first > WIDTH) ? 2U : 1U;
        const uint32_t filled = (ROWS - first < 2U * WIDTH) ? ROWS : first + 2U * WIDTH;
        /* A zero times a multiplier that is no number is no zero: then nothing is skipped. */
        const sides_t sides = {panels, count, finite ? first : 0U, finite ? WIDTH : 0U, filled, zeros};
        for (uint32_t panel = 0U; panel < count; panel++) {
            fill_identity(&panels[PANEL * panel], first + WIDTH * panel, sides.first, filled);
        }
        forward(work, &sides);
        backward(work, &sides);
        for (uint32_t column = first; column < SIZE && column < first + 2U * WIDTH; column += 4U) {
            const uint32_t columns = (SIZE - column < 4U) ? SIZE - column : 4U;
            const $real *const own = &panels[PANEL * ((column - first) / WIDTH)];
            give_columns(a, &own[(column - first) % WIDTH], &work->order[column], columns);
        }
    }
}
