/* Takes a column times a number from four numbers. */
static inline void take(four_t *four, const $real *column, $real number)
{
    const four_t factor = load_four(column);
    four->a -= factor.a * number;
    four->b -= factor.b * number;
    four->c -= factor.c * number;
    four->d -= factor.d * number;
}

/* Takes four columns times four numbers, the first first. */
static inline void take_four(four_t *four, const $real *columns, const $real *numbers)
{
#if defined(LOAD_MULTIPLE)
    const tile_t tile = load_tile(columns);
    const four_t number = load_four(numbers);
    *four = minus(*four, number.a, tile.r0);
    *four = minus(*four, number.b, tile.r1);
    *four = minus(*four, number.c, tile.r2);
    *four = minus(*four, number.d, tile.r3);
#else
    take(four, columns, numbers[0]);
    take(four, &columns[4], numbers[1]);
    take(four, &columns[8], numbers[2]);
    take(four, &columns[12], numbers[3]);
#endif
}

/* The same, the last first. */
static inline void take_four_backwards(four_t *four, const $real *columns, const $real *numbers)
{
#if defined(LOAD_MULTIPLE)
    const tile_t tile = load_tile(columns);
    const four_t number = load_four(numbers);
    *four = minus(*four, number.d, tile.r3);
    *four = minus(*four, number.c, tile.r2);
    *four = minus(*four, number.b, tile.r1);
    *four = minus(*four, number.a, tile.r0);
#else
    take(four, &columns[12], numbers[3]);
    take(four, &columns[8], numbers[2]);
    take(four, &columns[4], numbers[1]);
    take(four, columns, numbers[0]);
#endif
}

static inline void store_four($real *to, four_t four)
{
    to[0] = four.a;
    to[1] = four.b;
    to[2] = four.c;
    to[3] = four.d;
}

/* Solves by L, four rows at a time. */
NOT_INLINE static void forward(const $real *tiles, $real *x)
{
    for (uint32_t row = 0U; row < ROWS; row += 4U) {
        const $real *column = &tiles[place(row, 0U)];
        four_t four = {x[row], x[row + 1U], x[row + 2U], x[row + 3U]};
        uint32_t until_next = (WIDTH - BEFORE) / 4U;
        for (uint32_t known = 0U; known < row; known += 4U) {
            take_four(&four, column, &x[known]);
            column += 16;
            until_next--;
            if (WIDTH == 4U || until_next == 0U) {
                column += PANEL - TILE;
                until_next = WIDTH / 4U;
            }
        }
        four.b -= column[1] * four.a;
        four.c -= column[2] * four.a;
        four.d -= column[3] * four.a;
        four.c -= column[6] * four.b;
        four.d -= column[7] * four.b;
        four.d -= column[11] * four.c;
        store_four(&x[row], four);
    }
}

/* Solves by U, from the last rows upwards. */
NOT_INLINE static void backward(const $real *tiles, $real *x)
{
    for (uint32_t below = ROWS; below > 0U; below -= 4U) {
        const uint32_t row = below - 4U;
        const $real *column = &tiles[place(row, ROWS - 4U)];
        four_t four = {x[row], x[row + 1U], x[row + 2U], x[row + 3U]};
        uint32_t until_next = WIDTH / 4U;
        for (uint32_t known = ROWS - 4U; known > row; known -= 4U) {
            take_four_backwards(&four, column, &x[known]);
            column -= 16;
            until_next--;
            if (WIDTH == 4U || until_next == 0U) {
                column -= PANEL - TILE;
                until_next = WIDTH / 4U;
            }
        }
        four.d = four.d / column[15];
        four.c -= column[14] * four.d;
        four.b -= column[13] * four.d;
        four.a -= column[12] * four.d;
        four.c = four.c / column[10];
        four.b -= column[9] * four.c;
        four.a -= column[8] * four.c;
        four.b = four.b / column[5];
        four.a -= column[4] * four.b;
        four.a = four.a / column[0];
        store_four(&x[row], four);
    }
}
