/* Four numbers, and a row of a panel: in the vectors of the target where the compiler has them, else
   one by one. Each number is rounded as it would be alone. */
typedef struct {
    $real a;
    $real b;
    $real c;
    $real d;
} four_t;
$targets
#if defined(__GNUC__) && !defined(BESSEMER_PLAIN) && !defined(FEW_REGISTERS)
/* Keeps steps apart, so that each number is loaded once for a tile. */
#define APART(pointer) __asm__("" : "+r"(pointer))
#else
#define APART(pointer) ((void)(pointer))
#endif

/* A tile fills the registers: it needs a function for itself. */
#if defined(__GNUC__)
#define NOT_INLINE __attribute__((noinline))
#else
#define NOT_INLINE
#endif

#if defined(WORDS)
static inline four_t load_four(const $real *from)
{
    union {
        int64x1x4_t words;
        four_t four;
    } loaded;
    loaded.words = vld4_s64((const word_t *)from);
    return loaded.four;
}
#else
static inline four_t load_four(const $real *from)
{
    const four_t four = {from[0], from[1], from[2], from[3]};
    return four;
}
#endif

#if defined(HALF)
typedef struct {
    half_t low;
    half_t high;
} row_t;

static inline row_t load_row(const $real *from)
{
    const row_t row = {*(const half_t *)from, *(const half_t *)&from[HALF]};
    return row;
}

static inline void store_row($real *to, row_t row)
{
    *(half_t *)to = row.low;
    *(half_t *)&to[HALF] = row.high;
}

/* Empty code that claims to change a row: compilers must have it in registers at this point, and use those from here on. It
   makes no instruction, and no bit depends on it. */
#define HOLD(row) __asm__("" : "+v"((row).low), "+v"((row).high))

#if defined(FEW_REGISTERS)
/* Without it compilers mix the steps until the rows of a tile no longer fit into registers: the same results, in a third
   more time. */
#define IN_REGISTERS(row) HOLD(row)
#else
#define IN_REGISTERS(row) ((void)(row))
#endif

static inline row_t load_operand(const $real *from)
{
    row_t row = load_row(from);
    $hold(row);
    return row;
}

/* row - factor * other */
static inline row_t minus(row_t row, $real factor, row_t other)
{
    const row_t rest = {$low, $high};
    return rest;
}
#else
typedef four_t row_t;

static inline row_t load_row(const $real *from)
{
    const row_t row = {from[0], from[1], from[2], from[3]};
    return row;
}

static inline void store_row($real *to, row_t row)
{
    to[0] = row.a;
    to[1] = row.b;
    to[2] = row.c;
    to[3] = row.d;
}

/* row - factor * other */
static inline row_t minus(row_t row, $real factor, row_t other)
{
    const row_t rest = {row.a - factor * other.a, row.b - factor * other.b,
        row.c - factor * other.c, row.d - factor * other.d};
    return rest;
}
#endif

/* The first place in a buffer from which no vector lies across two cache lines. */
static inline $real *aligned($real *buffer)
{
#if defined(HALF)
    const uintptr_t beyond = (uintptr_t)buffer % 64U;
    return &buffer[(64U - beyond) % 64U / sizeof(*buffer)];
#else
    return buffer;
#endif
}

#if defined(QUAD)
static inline quad_lanes_t load_quad(const $real *from)
{
    return *(const quad_lanes_t *)from;
}

static inline void store_quad($real *to, quad_lanes_t quad)
{
    *(quad_lanes_t *)to = quad;
}

static inline quad_lanes_t minus_quad(quad_lanes_t quad, $real factor, quad_lanes_t other)
{
    return quad - factor * other;
}

static inline quad_lanes_t times_quad(quad_lanes_t quad, $real factor)
{
    return quad * factor;
}

/* Four rows of four, so far apart, become columns. */
static inline void transpose(const $real *from, uint32_t apart, $real *to, uint32_t beside)
{
    const quad_lanes_t a = load_quad(from);
    const quad_lanes_t b = load_quad(&from[apart]);
    const quad_lanes_t c = load_quad(&from[2U * apart]);
    const quad_lanes_t d = load_quad(&from[3U * apart]);
    const quad_lanes_t ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const quad_lanes_t ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const quad_lanes_t cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const quad_lanes_t cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    store_quad(to, __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5));
    store_quad(&to[beside], __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5));
    store_quad(&to[2U * beside], __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7));
    store_quad(&to[3U * beside], __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7));
}
#else
typedef row_t quad_lanes_t;
#define load_quad load_row
#define store_quad store_row
#define minus_quad minus

static inline quad_lanes_t times_quad(quad_lanes_t quad, $real factor)
{
#if defined(HALF)
    const quad_lanes_t product = {quad.low * factor, quad.high * factor};
#else
    const quad_lanes_t product = {
        quad.a * factor, quad.b * factor, quad.c * factor, quad.d * factor};
#endif
    return product;
}

/* Four rows of four, so far apart, become columns. */
static inline void transpose(const $real *from, uint32_t apart, $real *to, uint32_t beside)
{
    const four_t a = load_four(from);
    const four_t b = load_four(&from[apart]);
    const four_t c = load_four(&from[2U * apart]);
    const four_t d = load_four(&from[3U * apart]);
    to[0] = a.a;
    to[1] = b.a;
    to[2] = c.a;
    to[3] = d.a;
    to[beside] = a.b;
    to[beside + 1U] = b.b;
    to[beside + 2U] = c.b;
    to[beside + 3U] = d.b;
    to[2U * beside] = a.c;
    to[2U * beside + 1U] = b.c;
    to[2U * beside + 2U] = c.c;
    to[2U * beside + 3U] = d.c;
    to[3U * beside] = a.d;
    to[3U * beside + 1U] = b.d;
    to[3U * beside + 2U] = c.d;
    to[3U * beside + 3U] = d.d;
}
#endif
