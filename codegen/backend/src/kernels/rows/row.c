/* Elimination by rows: a row is a few vectors of the target, PITCH numbers from the next. Each number is
   rounded as it would be alone. */
#define PARTS (($n + LANES - 1U) / LANES)
#define PITCH $pitch
/* The lane of the first column. */
#define FIRST $first

typedef $real lanes_t __attribute__((vector_size($bytes * LANES), may_alias));
/* As many numbers as a square that is transposed has on a side. */
typedef $real side_t __attribute__((vector_size($bytes * SIDE), aligned($bytes), may_alias));

/* A multiplier times a row, from the vector `first` on, is added to another row. */
static inline __attribute__((always_inline)) void add($real *row, $real multiplier, const lanes_t *other,
    const uint32_t first)
{
#pragma GCC unroll 16
    for (uint32_t part = first; part < PARTS; part++) {
        lanes_t *const own = (lanes_t *)&row[LANES * part];
        *own += multiplier * other[part];
    }
}

/* The row of a pivot goes to the top, whose row takes its place: from the vector `first` on. */
static inline __attribute__((always_inline)) void exchange_parts($real *top, $real *row, const lanes_t *pivot,
    const uint32_t first)
{
#pragma GCC unroll 16
    for (uint32_t part = first; part < PARTS; part++) {
        *(lanes_t *)&row[LANES * part] = *(const lanes_t *)&top[LANES * part];
        *(lanes_t *)&top[LANES * part] = pivot[part];
    }
}

/* A row that a pivot may be in, and the magnitude of its number. */
typedef struct {
    uint32_t row;
    $real magnitude;
} candidate_t;

/* Takes a row for the pivot's if its number is larger: without a branch, which would be guessed wrongly. */
static inline void prefer(candidate_t *best, uint32_t row, $real number)
{
    const $real magnitude = $abs(number);
    best->row = (magnitude > best->magnitude) ? row : best->row;
    best->magnitude = (magnitude > best->magnitude) ? magnitude : best->magnitude;
}

/* The first place in a buffer where a vector may lie. */
static inline $real *first_vector($real *buffer)
{
    const uintptr_t beyond = (uintptr_t)buffer % sizeof(lanes_t);
    return &buffer[(sizeof(lanes_t) - beyond) % sizeof(lanes_t) / sizeof(*buffer)];
}

/* Rows of a square, so far apart, become columns. */
static inline void transpose_square(const $real *from, uint32_t apart, $real *to, uint32_t beside)
{
#if SIDE == 2U
    const side_t a = *(const side_t *)from;
    const side_t b = *(const side_t *)&from[apart];
    *(side_t *)to = __builtin_shufflevector(a, b, 0, 2);
    *(side_t *)&to[beside] = __builtin_shufflevector(a, b, 1, 3);
#else
    const side_t a = *(const side_t *)from;
    const side_t b = *(const side_t *)&from[apart];
    const side_t c = *(const side_t *)&from[2U * apart];
    const side_t d = *(const side_t *)&from[3U * apart];
    const side_t ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const side_t ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const side_t cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const side_t cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    *(side_t *)to = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
    *(side_t *)&to[beside] = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
    *(side_t *)&to[2U * beside] = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
    *(side_t *)&to[3U * beside] = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
#endif
}

/* The first number of a square: the last square overlaps the one before, so that no rest needs code of its own. */
static inline uint32_t corner(uint32_t at)
{
    return (at + SIDE > $n) ? $n - SIDE : at;
}

/* The matrix, by rows. */
static inline void bring_rows($real *rows, const $real *a)
{
    if ($n % LANES != 0U) {
        /* What fills a row up. */
        for (uint32_t row = 0U; row < $n; row++) {
            const lanes_t zeros = {$zero};
            *(lanes_t *)&rows[PITCH * row + $filled] = zeros;
        }
    }
    for (uint32_t to = 0U; to < $n; to += SIDE) {
        const uint32_t column = corner(to);
        for (uint32_t from = 0U; from < $n; from += SIDE) {
            const uint32_t row = corner(from);
            transpose_square(&a[row + $n * column], $n, &rows[PITCH * row + FIRST + column], PITCH);
        }
    }
}

/* The first of the largest magnitudes in the first column. */
static inline candidate_t find_first(const $real *a)
{
    candidate_t best = {0U, $abs(a[0])};
#pragma GCC unroll 32
    for (uint32_t row = 1U; row < $n; row++) {
        prefer(&best, row, a[row]);
    }
    return best;
}
