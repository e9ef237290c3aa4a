/* The first row of a vector; the last vector overlaps where the rows are no multiple of its lanes. */
$height#define OFFSET(vector) ((LANES * (vector) + LANES <= $rows) ? LANES * (vector) : $rows - LANES)

/* The first term of a sum, and the sum with one more. */
$sum
typedef $real lanes_t __attribute__((vector_size($bytes * LANES), aligned($bytes), may_alias));
