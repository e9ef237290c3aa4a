/*
 * Rows of the matrix stay where they are, and `order` says which of them each pivot took, so that nothing on the left of a
 * panel is ever exchanged. A panel, WIDTH columns, is brought in by rows in the order so far, goes through all columns
 * on its left from the first to the last, a tile of rows at a time, and is then factored by columns. So an element
 * sees its steps in their order.
 */
/* Columns that the first panel lacks, so that all others are whole. */
#define BEFORE ((WIDTH - ROWS % WIDTH) % WIDTH)
/* Rows that go through a column side by side, and numbers from a column of the block to the next. */
#define GROUP (4U * HALF)
#define BLOCK ((ROWS + GROUP - 1U) / GROUP * GROUP)

typedef struct {
    /* By rows: the multipliers, and from the diagonal on what is left of the matrix. */
    $real *rows;
    /* The panel at work, by rows in their order: what comes in, and what is done with. */
    $real *panel;
    /* Its rows from the diagonal down, by columns. */
    $real *block;
#if defined(SIDE)
    /* The right-hand side, in the order of the rows. */
    $real *x;
#endif
    /* Which row of the matrix stands where, and where a row stands. */
    uint32_t *order;
    uint32_t *place;
} elimination_t;

/* The number of a row, by its order, and a column. */
static inline $real *at(const elimination_t *work, uint32_t row, uint32_t column)
{
    return &work->rows[ROWS * work->order[row] + column];
}

/* Columns of the panel that begins with this one. */
static inline uint32_t columns_from(uint32_t first)
{
    const uint32_t columns = (first == 0U) ? WIDTH - BEFORE : WIDTH;
    return (SIZE - first < columns) ? SIZE - first : columns;
}

$tile
/* Before the first panel: the order is that of the matrix. */
static void begin(const elimination_t *work)
{
    for (uint32_t row = 0U; row < ROWS; row++) {
        work->order[row] = row;
        work->place[row] = row;
    }
}

/* Brings columns of the matrix into the panel, by rows in their order; beyond the matrix are zeros. */
NOT_INLINE static void fill_panel(const elimination_t *work, const $real *a, uint32_t first)
{
    const uint32_t *const place = work->place;
    for (uint32_t column = first; column < first + WIDTH; column += 4U) {
        $real *const panel = &work->panel[column - first];
        uint32_t row = 0U;
        for (; column + 4U <= SIZE && row + 4U <= SIZE; row += 4U) {
            const $real *const from = &a[row + SIZE * column];
            store_square(&panel[WIDTH * place[row]], &panel[WIDTH * place[row + 1U]],
                &panel[WIDTH * place[row + 2U]], &panel[WIDTH * place[row + 3U]],
                turned(load_square(from, &from[SIZE], &from[2U * SIZE], &from[3U * SIZE])));
        }
        for (; row < ROWS; row++) {
            for (uint32_t lane = 0U; lane < 4U; lane++) {
                const bool there = row < SIZE && column + lane < SIZE;
                panel[WIDTH * place[row] + lane] = there ? a[row + SIZE * (column + lane)] : $zero;
            }
        }
    }
}

/* The first panel has nothing on its left: its columns go into the block as they are. */
static void fill_block(const elimination_t *work, const $real *a)
{
    for (uint32_t column = 0U; column < WIDTH; column++) {
        (void)memcpy(&work->block[BLOCK * column], &a[SIZE * column], SIZE * sizeof(*a));
    }
}

/* What fills the block's last group up. */
static void pad_block(const elimination_t *work, uint32_t rows)
{
    for (uint32_t row = rows; row % GROUP != 0U; row++) {
        for (uint32_t column = 0U; column < WIDTH; column++) {
            work->block[BLOCK * column + row] = $zero;
        }
    }
}

/* Brings the multipliers below the panel's own rows, which are as many as its columns, from the block into the matrix. */
NOT_INLINE static void keep_multipliers(const elimination_t *work, uint32_t first, uint32_t columns)
{
    for (uint32_t lane = 0U; lane < columns; lane += 4U) {
        const $real *const from = &work->block[BLOCK * lane];
        for (uint32_t row = first + columns; row < ROWS; row += 4U) {
            const $real *const column = &from[row - first];
            store_square(at(work, row, first + lane), at(work, row + 1U, first + lane),
                at(work, row + 2U, first + lane), at(work, row + 3U, first + lane),
                turned(load_square(column, &column[BLOCK], &column[2U * BLOCK], &column[3U * BLOCK])));
        }
    }
}

/* As many numbers of a column as go through it side by side. */
typedef struct {
    half_t a;
    half_t b;
    half_t c;
    half_t d;
} group_t;

static inline group_t load_group(const $real *from)
{
    const group_t group = {*(const half_t *)from, *(const half_t *)&from[HALF],
        *(const half_t *)&from[2U * HALF], *(const half_t *)&from[3U * HALF]};
    return group;
}

static inline void store_group($real *to, group_t group)
{
    *(half_t *)to = group.a;
    *(half_t *)&to[HALF] = group.b;
    *(half_t *)&to[2U * HALF] = group.c;
    *(half_t *)&to[3U * HALF] = group.d;
}

static inline group_t times(group_t group, $real factor)
{
    const group_t product = {
        group.a * factor, group.b * factor, group.c * factor, group.d * factor};
    return product;
}

/* group - factor * other */
static inline group_t minus_group(group_t group, $real factor, group_t other)
{
#if defined(FAST)
    const group_t rest = {MINUS(group.a, factor, other.a), MINUS(group.b, factor, other.b),
        MINUS(group.c, factor, other.c), MINUS(group.d, factor, other.d)};
#else
    const group_t rest = {group.a - factor * other.a, group.b - factor * other.b,
        group.c - factor * other.c, group.d - factor * other.d};
#endif
    return rest;
}

static inline half_t magnitudes(half_t numbers)
{
    return (half_t)((half_bits_t)numbers & $magnitude_bits);
}

/* The larger of each two magnitudes; the second where one is NaN. */
static inline half_t larger(half_t magnitude, half_t largest)
{
    return (half_t)$maximum(($x86_vector)magnitude, ($x86_vector)largest);
}

/* Takes columns of the block, so many, times numbers, each so far from the last, from a column; the last of them
   becomes multipliers on the way. Gives the largest magnitude that is then in the column, or zero. */
NOT_INLINE static $real subtract_columns(const elimination_t *work, $real *column, uint32_t rows, uint32_t columns,
    const $real *numbers, uint32_t apart, $real reciprocal)
{
    half_t largest = {$zero};
    half_t other = {$zero};
    for (uint32_t row = 0U; row < rows; row += GROUP) {
        group_t group = load_group(&column[row]);
        $real *multipliers = &work->block[row];
        const $real *number = numbers;
        for (uint32_t k = 1U; k < columns; k++) {
            group = minus_group(group, *number, load_group(multipliers));
            multipliers += BLOCK;
            number += apart;
        }
        if (columns > 0U) {
            const group_t last = times(load_group(multipliers), reciprocal);
            store_group(multipliers, last);
            group = minus_group(group, *number, last);
            store_group(&column[row], group);
        }
        largest = larger(magnitudes(group.a), largest);
        other = larger(magnitudes(group.b), other);
        largest = larger(magnitudes(group.c), largest);
        other = larger(magnitudes(group.d), other);
    }
    largest = larger(other, largest);
    $real most = largest[0];
    for (uint32_t lane = 1U; lane < HALF; lane++) {
        most = (largest[lane] > most) ? largest[lane] : most;
    }
    return most;
}

static inline bool has(group_t group, $real magnitude)
{
    const half_bits_t found = (half_bits_t)((magnitudes(group.a) == magnitude) | (magnitudes(group.b) == magnitude)
        | (magnitudes(group.c) == magnitude) | (magnitudes(group.d) == magnitude));
    bool any = false;
    for (uint32_t lane = 0U; lane < HALF; lane++) {
        any = any || found[lane] != 0;
    }
    return any;
}

/* The first row of a column with this magnitude, which is there. */
static inline uint32_t find(const $real *column, $real magnitude)
{
    uint32_t row = 0U;
    while (!has(load_group(&column[row]), magnitude)) {
        row += GROUP;
    }
    while ($abs(column[row]) != magnitude) {
        row++;
    }
    return row;
}

/* A row of the block. */
static inline row_t load_across(const elimination_t *work, uint32_t row)
{
    const row_t across = {vector_across(&work->block[row]), vector_across(&work->block[HALF * BLOCK + row])};
    return across;
}

/* Takes the row of a pivot, which is found at another place, out of the block, one number after another. */
static inline void take_out(const elimination_t *work, uint32_t own, uint32_t other, $real *taken)
{
    for (uint32_t column = 0U; column < WIDTH; column++) {
        $real *const numbers = &work->block[BLOCK * column];
        taken[column] = numbers[other];
        numbers[other] = numbers[own];
        /* No pivot any more. */
        numbers[own] = $zero;
    }
}

static inline void exchange(const elimination_t *work, uint32_t row, uint32_t other)
{
    const uint32_t number = work->order[row];
    work->order[row] = work->order[other];
    work->order[other] = number;
    work->place[work->order[row]] = row;
    work->place[number] = other;
}

#if defined(SIDE)
/* The right-hand side's number of a pivot's row, which is found at another place, goes through the columns on its left. */
static inline $real eliminate_side(const elimination_t *work, uint32_t first, uint32_t own, uint32_t other, const $real *y)
{
    $real *const x = &work->x[first];
    $real number = x[other];
    x[other] = x[own];
    for (uint32_t k = 0U; k < own; k++) {
        number -= work->block[BLOCK * k + other] * y[k];
    }
    return number;
}

#else
/* The panel's last column becomes multipliers. */
static inline void scale_column($real *column, uint32_t rows, $real reciprocal)
{
    for (uint32_t row = 0U; row < rows; row += GROUP) {
        store_group(&column[row], times(load_group(&column[row]), reciprocal));
    }
}

#endif
/* A step of the panel: what is on the right of a pivot goes through the columns on its left. Gives the pivot. */
NOT_INLINE static $real eliminate(const elimination_t *work, uint32_t first, uint32_t own, uint32_t other)
{
    $real *const panel = &work->panel[WIDTH * first];
    row_t row = load_across(work, other);
    $real taken[WIDTH];
    take_out(work, own, other, taken);
    for (uint32_t k = 0U; k < own; k++) {
        row = minus(row, taken[k], load_row(&panel[WIDTH * k]));
    }
    store_row(&panel[WIDTH * own], row);
    exchange(work, first + own, first + other);
    $real *const to = at(work, first + own, first);
    store_row(to, row);
    /* Multipliers, and the pivot, which has lost its steps before. */
    for (uint32_t k = 0U; k <= own; k++) {
        to[k] = taken[k];
    }
    return taken[own];
}

#if defined(SIDE)
/* Factors a panel by columns, from the diagonal down, and takes it from the right-hand side. False if a pivot is zero. */
#else
/* Factors a panel by columns, from the diagonal down. False if a pivot is zero. */
#endif
NOT_INLINE static bool factor_panel(const elimination_t *work, uint32_t first, uint32_t columns)
{
    const uint32_t rows = ROWS - first;
#if defined(SIDE)
    $real y[WIDTH];
#endif
    $real reciprocal = $one;
    for (uint32_t own = 0U; own < columns; own++) {
        $real *const column = &work->block[BLOCK * own];
        const $real magnitude = subtract_columns(
            work, column, rows, own, &work->panel[WIDTH * first + own], WIDTH, reciprocal);
        /* A NaN is no pivot, unless it stands first. */
        const uint32_t other = (column[own] == column[own]) ? find(column, magnitude) : own;
        if (column[other] == $zero) {
            return false;
        }
#if defined(SIDE)
        y[own] = eliminate_side(work, first, own, other, y);
#endif
        reciprocal = $one / eliminate(work, first, own, other);
#if defined(FAST)
        /* In the place of the pivot: products take less time than quotients. */
        *at(work, first + own, first + own) = reciprocal;
#endif
    }
#if defined(SIDE)
    $real *const x = &work->x[first];
    if (first + columns < SIZE) {
        (void)subtract_columns(work, x, rows, columns, y, 1U, reciprocal);
    }
    (void)memcpy(x, y, columns * sizeof(*x));
#else
    if (first + columns < SIZE) {
        scale_column(&work->block[BLOCK * (columns - 1U)], rows, reciprocal);
    }
#endif
    return true;
}

#if defined(SIDE)
/* Factors the matrix, and solves by L. False if a pivot is zero. */
#else
/* Factors the matrix. False if a pivot is zero. */
#endif
NOT_INLINE static bool eliminate_all(const elimination_t *work, const $real *a)
{
    uint32_t columns = 0U;
    for (uint32_t first = 0U; first < SIZE; first += columns) {
        columns = columns_from(first);
        if (first == 0U) {
            fill_block(work, a);
        } else {
            fill_panel(work, a, first);
            subtract_above(work, first);
            subtract_below(work, first);
        }
        pad_block(work, SIZE - first);
        if (!factor_panel(work, first, columns)) {
            return false;
        }
        if (first + columns < SIZE) {
            keep_multipliers(work, first, columns);
        }
    }
    return true;
}
