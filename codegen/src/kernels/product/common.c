/* The rows of a band; the last vector overlaps where they are no multiple of its lanes. */
#define HEIGHT ((LANES * DOWN < $rows) ? LANES * DOWN : $rows)
#define OFFSET(vector) ((LANES * (vector) + LANES <= $rows) ? LANES * (vector) : $rows - LANES)

#if !defined(PLUS)
#define TIMES(rows, number) ((rows) * (number))
#define PLUS(sum, rows, number) ((sum) + (rows) * (number))
#endif

typedef $real lanes_t __attribute__((vector_size($bytes * LANES), aligned($bytes), may_alias));
