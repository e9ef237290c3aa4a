/* Rows of a tile. */
typedef struct {
    row_t r0;
    row_t r1;
    row_t r2;
    row_t r3;
} tile_t;

#if defined(LOAD_MULTIPLE)
/* Sixteen numbers in as many registers that follow one another: one instruction loads or stores them all. */
static inline tile_t load_tile(const $real *from)
{
    register $real a0 __asm__("$r0_"), a1 __asm__("$r1_"), a2 __asm__("$r2_"), a3 __asm__("$r3_");
    register $real b0 __asm__("$r4_"), b1 __asm__("$r5_"), b2 __asm__("$r6_"), b3 __asm__("$r7_");
    register $real c0 __asm__("$r8_"), c1 __asm__("$r9_"), c2 __asm__("$r10_"), c3 __asm__("$r11_");
    register $real d0 __asm__("$r12_"), d1 __asm__("$r13_"), d2 __asm__("$r14_"), d3 __asm__("$r15_");
    __asm__("vldmia %[from], {$r0_-$r15_}"
        : "=$w"(a0), "=$w"(a1), "=$w"(a2), "=$w"(a3),
          "=$w"(b0), "=$w"(b1), "=$w"(b2), "=$w"(b3),
          "=$w"(c0), "=$w"(c1), "=$w"(c2), "=$w"(c3),
          "=$w"(d0), "=$w"(d1), "=$w"(d2), "=$w"(d3)
        : [from] "r"(from), "m"(*(const $real (*)[16])from));
    const tile_t tile = {{a0, a1, a2, a3}, {b0, b1, b2, b3}, {c0, c1, c2, c3}, {d0, d1, d2, d3}};
    return tile;
}

static inline void store_tile($real *to, const tile_t *tile)
{
    register const $real a0 __asm__("$r0_") = tile->r0.a, a1 __asm__("$r1_") = tile->r0.b;
    register const $real a2 __asm__("$r2_") = tile->r0.c, a3 __asm__("$r3_") = tile->r0.d;
    register const $real b0 __asm__("$r4_") = tile->r1.a, b1 __asm__("$r5_") = tile->r1.b;
    register const $real b2 __asm__("$r6_") = tile->r1.c, b3 __asm__("$r7_") = tile->r1.d;
    register const $real c0 __asm__("$r8_") = tile->r2.a, c1 __asm__("$r9_") = tile->r2.b;
    register const $real c2 __asm__("$r10_") = tile->r2.c, c3 __asm__("$r11_") = tile->r2.d;
    register const $real d0 __asm__("$r12_") = tile->r3.a, d1 __asm__("$r13_") = tile->r3.b;
    register const $real d2 __asm__("$r14_") = tile->r3.c, d3 __asm__("$r15_") = tile->r3.d;
    __asm__("vstmia %[to], {$r0_-$r15_}"
        : "=m"(*($real (*)[16])to)
        : [to] "r"(to), "$w"(a0), "$w"(a1), "$w"(a2), "$w"(a3),
          "$w"(b0), "$w"(b1), "$w"(b2), "$w"(b3),
          "$w"(c0), "$w"(c1), "$w"(c2), "$w"(c3),
          "$w"(d0), "$w"(d1), "$w"(d2), "$w"(d3));
}
#else
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
#endif

#if defined(WORDS)
/* Four numbers of each of four columns of the matrix. */
static inline tile_t load_columns(const $real *from)
{
    register $real a0 __asm__("d16"), a1 __asm__("d17"), a2 __asm__("d18"), a3 __asm__("d19");
    register $real b0 __asm__("d20"), b1 __asm__("d21"), b2 __asm__("d22"), b3 __asm__("d23");
    register $real c0 __asm__("d24"), c1 __asm__("d25"), c2 __asm__("d26"), c3 __asm__("d27");
    register $real d0 __asm__("d28"), d1 __asm__("d29"), d2 __asm__("d30"), d3 __asm__("d31");
    __asm__("vldmia %[first], {d16-d19}\n\tvldmia %[second], {d20-d23}\n\t"
            "vldmia %[third], {d24-d27}\n\tvldmia %[fourth], {d28-d31}"
        : "=w"(a0), "=w"(a1), "=w"(a2), "=w"(a3),
          "=w"(b0), "=w"(b1), "=w"(b2), "=w"(b3),
          "=w"(c0), "=w"(c1), "=w"(c2), "=w"(c3),
          "=w"(d0), "=w"(d1), "=w"(d2), "=w"(d3)
        : [first] "r"(from), [second] "r"(&from[SIZE]), [third] "r"(&from[2U * SIZE]),
          [fourth] "r"(&from[3U * SIZE]), "m"(*(const $real (*)[3U * SIZE + 4U])from));
    const tile_t tile = {{a0, a1, a2, a3}, {b0, b1, b2, b3}, {c0, c1, c2, c3}, {d0, d1, d2, d3}};
    return tile;
}

#define EXCHANGE(number, other) __asm__("vswp %P0, %P1" : "+w"(number), "+w"(other))

/* Its rows become columns. */
static inline void turn(tile_t *tile)
{
    EXCHANGE(tile->r0.b, tile->r1.a);
    EXCHANGE(tile->r0.c, tile->r2.a);
    EXCHANGE(tile->r0.d, tile->r3.a);
    EXCHANGE(tile->r1.c, tile->r2.b);
    EXCHANGE(tile->r1.d, tile->r3.b);
    EXCHANGE(tile->r2.d, tile->r3.c);
}

/* A tile of the panel becomes columns, which stand one after another. */
static inline void to_columns(const $real *rows, $real *columns)
{
    tile_t tile = load_tile(rows);
    turn(&tile);
    store_tile(columns, &tile);
}

/* Four rows of four columns of the matrix become rows of the panel. */
static inline void to_rows(const $real *columns, $real *rows)
{
    tile_t tile = load_columns(columns);
    turn(&tile);
    store_tile(rows, &tile);
}
#else
/* Four columns of a tile of the panel, one after another. */
static inline void to_columns(const $real *rows, $real *columns)
{
    transpose(rows, WIDTH, columns, 4U);
}

/* Four rows of four columns of the matrix become rows of the panel. */
static inline void to_rows(const $real *columns, $real *rows)
{
    transpose(columns, SIZE, rows, WIDTH);
}
#endif

#if defined(SINGLES)
/* Takes a row, times the four multipliers of a column, from the rows of the tile; an instruction loads each, and goes on to
   the next. */
static inline void step_on(tile_t *tile, const $real **columns, const $real **rows)
{
    const $real *column = *columns;
    const $real *row = *rows;
    register $real f0 __asm__("s16"), f1 __asm__("s17"), f2 __asm__("s18"), f3 __asm__("s19");
    register $real o0 __asm__("s20"), o1 __asm__("s21"), o2 __asm__("s22"), o3 __asm__("s23");
    __asm__("vldmia %[column]!, {s16-s19}\n\tvldmia %[row]!, {s20-s23}"
        : "=t"(f0), "=t"(f1), "=t"(f2), "=t"(f3), "=t"(o0), "=t"(o1), "=t"(o2), "=t"(o3),
          [column] "+r"(column), [row] "+r"(row)
        : "m"(*(const $real (*)[4])*columns), "m"(*(const $real (*)[4])*rows));
    const row_t other = {o0, o1, o2, o3};
    tile->r0 = minus(tile->r0, f0, other);
    tile->r1 = minus(tile->r1, f1, other);
    tile->r2 = minus(tile->r2, f2, other);
    tile->r3 = minus(tile->r3, f3, other);
    *columns = column;
    *rows = row;
}

/* The same of one. */
static inline void step(tile_t *tile, const $real *column, const $real *row)
{
    step_on(tile, &column, &row);
}
#else
/* Takes a row, times the four multipliers of a column, from the rows of the tile. */
static inline void step(tile_t *tile, const $real *column, const $real *row)
{
#if defined(HALF)
    const four_t factor = load_four(column);
    const row_t other = load_operand(row);
    tile->r0 = minus(tile->r0, factor.a, other);
    tile->r1 = minus(tile->r1, factor.b, other);
    tile->r2 = minus(tile->r2, factor.c, other);
    tile->r3 = minus(tile->r3, factor.d, other);
    IN_REGISTERS(tile->r0);
    IN_REGISTERS(tile->r1);
    IN_REGISTERS(tile->r2);
    IN_REGISTERS(tile->r3);
#elif defined(WORDS)
    const four_t factor = load_four(column);
    const row_t other = load_four(row);
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
#endif

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
