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

/* Rows of a square, or its columns. */
typedef struct {
    quad_lanes_t a;
    quad_lanes_t b;
    quad_lanes_t c;
    quad_lanes_t d;
} square_t;

static inline square_t load_square(const $real *a, const $real *b, const $real *c, const $real *d)
{
    const square_t square = {load_quad(a), load_quad(b), load_quad(c), load_quad(d)};
    return square;
}

static inline void store_square($real *a, $real *b, $real *c, $real *d, square_t square)
{
    store_quad(a, square.a);
    store_quad(b, square.b);
    store_quad(c, square.c);
    store_quad(d, square.d);
}

/* Rows become columns. */
static inline square_t turned(square_t square)
{
    const quad_lanes_t ab_even = __builtin_shufflevector(square.a, square.b, 0, 4, 2, 6);
    const quad_lanes_t ab_odd = __builtin_shufflevector(square.a, square.b, 1, 5, 3, 7);
    const quad_lanes_t cd_even = __builtin_shufflevector(square.c, square.d, 0, 4, 2, 6);
    const quad_lanes_t cd_odd = __builtin_shufflevector(square.c, square.d, 1, 5, 3, 7);
    const square_t columns = {__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5),
        __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5),
        __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7),
        __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7)};
    return columns;
}
#else
typedef row_t quad_lanes_t;
#define load_quad load_row
#define store_quad store_row
#define minus_quad minus
#endif
