/* The magnitude's upper bits: of two numbers with different ones, the larger has the larger. */
static inline uint32_t rank($real number)
{
    $bits bits;
    (void)memcpy(&bits, &number, sizeof bits);
    return $rank << 1;
}

typedef struct {
    const $real *place;
    bool finite;
} pivot_t;

/* A number whose rank is not below the best one's: takes it if it is larger. Gives the best rank. */
NOT_INLINE static uint32_t consider(pivot_t *best, const $real *place)
{
    const $real magnitude = $abs(*place);
    if (magnitude > $abs(*best->place)) {
        best->place = place;
    } else if (magnitude != magnitude) {
        best->finite = false;
    } else {
        /* no larger */
    }
    return rank(*best->place);
}

/* The row of the first of the largest magnitudes in a column of tiles, from a row down. A NaN is no
   pivot, unless it stands first. */
NOT_INLINE static uint32_t find_pivot(const $real *column, uint32_t row, bool *finite)
{
    const $real *four = &column[WIDTH * (row - row % 4U)];
    pivot_t best = {&four[row % 4U], rank(four[row % 4U]) < $infinite};
    uint32_t highest = rank(*best.place);
    for (uint32_t lane = row % 4U + 1U; lane < 4U && row - row % 4U + lane < SIZE; lane++) {
        if (rank(four[lane]) >= highest) {
            highest = consider(&best, &four[lane]);
        }
    }
    uint32_t fours = (SIZE - (row - row % 4U)) / 4U;
    for (four += TILE; fours > 1U; fours--) {
        if (rank(four[0]) >= highest) {
            highest = consider(&best, &four[0]);
        }
        if (rank(four[1]) >= highest) {
            highest = consider(&best, &four[1]);
        }
        if (rank(four[2]) >= highest) {
            highest = consider(&best, &four[2]);
        }
        if (rank(four[3]) >= highest) {
            highest = consider(&best, &four[3]);
        }
        four += TILE;
    }
$tail    if (!best.finite) {
        *finite = false;
    }
    const uint32_t found = (uint32_t)(best.place - column);
    return 4U * (found / TILE) + found % TILE;
}

static inline void exchange_numbers($real *a, $real *b)
{
    const $real number = *a;
    *a = *b;
    *b = number;
}

/* Exchanges two rows of the tiles, so many fours of columns from the first. */
NOT_INLINE static void exchange_left($real *tiles, uint32_t row, uint32_t other, uint32_t fours)
{
    $real *a = &tiles[place(row - row % 4U, 0U) + row % 4U];
    $real *b = &tiles[place(other - other % 4U, 0U) + other % 4U];
    uint32_t until_next = (WIDTH - BEFORE) / 4U;
    for (; fours > 0U; fours--) {
        exchange_numbers(&a[0], &b[0]);
        exchange_numbers(&a[4], &b[4]);
        exchange_numbers(&a[8], &b[8]);
        exchange_numbers(&a[12], &b[12]);
        a += 16U;
        b += 16U;
        until_next--;
        if (WIDTH == 4U || until_next == 0U) {
            a += PANEL - TILE;
            b += PANEL - TILE;
            until_next = WIDTH / 4U;
        }
    }
}

/* Exchanges two rows of a panel. */
static inline void exchange_rows($real *a, $real *b)
{
#if defined(WORDS)
    const int64x1x4_t words = vld4_s64((const word_t *)a);
    vst4_s64((word_t *)a, vld4_s64((const word_t *)b));
    vst4_s64((word_t *)b, words);
#else
    const row_t row = load_row(a);
    store_row(a, load_row(b));
    store_row(b, row);
#endif
}

/* The first step of elimination in four columns of a tile: the first becomes multipliers, the others lose them times
   the numbers of the row of the pivot. */
static inline void eliminate_first($real *four, $real second, $real third, $real fourth, $real reciprocal)
{
#if defined(LOAD_MULTIPLE)
    tile_t columns = load_tile(four);
    columns.r0 = times_quad(columns.r0, reciprocal);
    columns.r1 = minus(columns.r1, second, columns.r0);
    columns.r2 = minus(columns.r2, third, columns.r0);
    columns.r3 = minus(columns.r3, fourth, columns.r0);
    store_tile(four, &columns);
#else
    const quad_lanes_t factor = times_quad(load_quad(four), reciprocal);
    const quad_lanes_t second_rest = minus_quad(load_quad(&four[4]), second, factor);
    const quad_lanes_t third_rest = minus_quad(load_quad(&four[8]), third, factor);
    const quad_lanes_t fourth_rest = minus_quad(load_quad(&four[12]), fourth, factor);
    store_quad(four, factor);
    store_quad(&four[4], second_rest);
    store_quad(&four[8], third_rest);
    store_quad(&four[12], fourth_rest);
#endif
}

/* The second step. */
static inline void eliminate_second($real *four, $real third, $real fourth, $real reciprocal)
{
#if defined(LOAD_MULTIPLE)
    tile_t columns = load_tile(four);
    columns.r1 = times_quad(columns.r1, reciprocal);
    columns.r2 = minus(columns.r2, third, columns.r1);
    columns.r3 = minus(columns.r3, fourth, columns.r1);
    store_tile(four, &columns);
#else
    const quad_lanes_t factor = times_quad(load_quad(&four[4]), reciprocal);
    const quad_lanes_t third_rest = minus_quad(load_quad(&four[8]), third, factor);
    const quad_lanes_t fourth_rest = minus_quad(load_quad(&four[12]), fourth, factor);
    store_quad(&four[4], factor);
    store_quad(&four[8], third_rest);
    store_quad(&four[12], fourth_rest);
#endif
}

/* A step of elimination in four columns, in the tiles below the one with the pivot: the pivot's column
   becomes multipliers, and the columns on its right lose them times the row of the pivot. */
NOT_INLINE static void eliminate($real *tile, uint32_t tiles, uint32_t step_of_four, const $real *pivot_row,
    $real reciprocal)
{
    const $real second = pivot_row[4];
    const $real third = pivot_row[8];
    const $real fourth = pivot_row[12];
    switch (step_of_four) {
    case 0:
        for (; tiles > 0U; tiles--) {
            eliminate_first(tile, second, third, fourth, reciprocal);
            tile += TILE;
        }
        break;
    case 1:
        for (; tiles > 0U; tiles--) {
            eliminate_second(tile, third, fourth, reciprocal);
            tile += TILE;
        }
        break;
    case 2:
        for (; tiles > 0U; tiles--) {
            const quad_lanes_t factor = times_quad(load_quad(&tile[8]), reciprocal);
            const quad_lanes_t rest = minus_quad(load_quad(&tile[12]), fourth, factor);
            store_quad(&tile[8], factor);
            store_quad(&tile[12], rest);
            tile += TILE;
        }
        break;
    default:
        for (; tiles > 0U; tiles--) {
            store_quad(&tile[12], times_quad(load_quad(&tile[12]), reciprocal));
            tile += TILE;
        }
        break;
    }
}

/* The same within the tile of the pivot. */
static inline $real eliminate_top($real *top, uint32_t step_of_four)
{
    const $real reciprocal = $one / top[5U * step_of_four];
    for (uint32_t lane = step_of_four + 1U; lane < 4U; lane++) {
        const $real factor = top[4U * step_of_four + lane] * reciprocal;
        top[4U * step_of_four + lane] = factor;
        for (uint32_t column = step_of_four + 1U; column < 4U; column++) {
            top[4U * column + lane] -= factor * top[4U * column + step_of_four];
        }
    }
    return reciprocal;
}

/* Four columns of a panel, which begin with column `first`: brings them into tiles and eliminates below
   the diagonal. False if there is no pivot. */
NOT_INLINE static bool factor_four($real *tiles, $real *panel, uint32_t first, uint32_t *pivots, bool *finite)
{
    const uint32_t lane = (first + BEFORE) % WIDTH;
    $real *const columns = &tiles[place(0U, first)];
    for (uint32_t row = 0U; row < ROWS; row += 4U) {
        to_columns(&panel[WIDTH * row + lane], &columns[WIDTH * row]);
    }
    $real *const top = &columns[WIDTH * first];
    for (uint32_t k = 0U; k < 4U && first + k < SIZE; k++) {
        const uint32_t pivot = find_pivot(&columns[4U * k], first + k, finite);
        pivots[first + k] = pivot;
        if (columns[WIDTH * (pivot - pivot % 4U) + 4U * k + pivot % 4U] == $zero) {
            return false;
        }
        if (pivot != first + k) {
            exchange_left(tiles, first + k, pivot, first / 4U + 1U);
            if (lane + 4U < WIDTH) {
                exchange_rows(&panel[WIDTH * (first + k)], &panel[WIDTH * pivot]);
            }
        }
        const $real reciprocal = eliminate_top(top, k);
        if (rank(reciprocal) >= $infinite) {
            *finite = false;
        }
        eliminate(&top[TILE], (ROWS - first) / 4U - 1U, k, &top[k], reciprocal);
    }
    return true;
}

/* Brings four columns of the matrix into a panel, its rows in the order of the pivots so far. */
NOT_INLINE static void fill_four($real *panel, const $real *a, uint32_t first)
{
    const $real *const columns = &a[SIZE * first];
    $real *const four = &panel[(first + BEFORE) % WIDTH];
$fill}

/* Factors a matrix by columns: first what is above a panel and in it, by the panels on its left, then
   the panel itself. False if a pivot is zero. */
NOT_INLINE static bool factor(const $real *a, $real *tiles, $real *panel, uint32_t *pivots, bool *finite)
{
    const uint32_t whole = WIDTH / 4U;
    for (uint32_t first = 0U; first < ROWS; first += 4U) {
        uint32_t lane = (first + BEFORE) % WIDTH;
        if (lane == 0U || first == 0U) {
            for (uint32_t column = first; column + lane < first + WIDTH; column += 4U) {
                fill_four(panel, a, column);
            }
            for (uint32_t row = 0U; row < first; row++) {
                exchange_rows(&panel[WIDTH * row], &panel[WIDTH * pivots[row]]);
            }
            for (uint32_t row = 0U; row < ROWS && first > 0U; row += 4U) {
                $real *const tile = &panel[WIDTH * row];
                const bool above = row < first;
                subtract(tile, tile, &tiles[place(row, 0U)], panel, (above ? row : first) / 4U,
                    (WIDTH - BEFORE) / 4U, above ? &tiles[place(row, row)] : NULL);
            }
        }
        if (!factor_four(tiles, panel, first, pivots, finite)) {
            return false;
        }
        /* The rest of the panel, by the four columns. */
        for (uint32_t row = first; row < ROWS && lane + 4U < WIDTH; row += 4U) {
            $real *const tile = &panel[WIDTH * row];
            const $real *const columns = &tiles[place(row, first)];
            const bool top = row == first;
            subtract(tile, tile, columns, &panel[WIDTH * first], top ? 0U : 1U, whole + 1U,
                top ? columns : NULL);
        }
    }
$pad    return true;
}
