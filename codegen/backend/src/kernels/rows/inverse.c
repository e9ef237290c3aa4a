/* Lanes to keep and lanes to clear, and a one among zeros: read from the middle on, less the row. */
static const $word KEPT[2U * PITCH] = {$kept};
static const $real UNIT[2U * PITCH] = {[PITCH] = $one};

/* Where a table is read from is any place. */
typedef $word words_t __attribute__((vector_size($bytes * LANES), aligned($bytes), may_alias));

/* Takes the row of a pivot from a row below it. What it does to the identity, whose columns are in the order of
   the pivots, stands where the matrix has become zero. Gives the number in the next column: computed by itself,
   for the next pivot does not wait for the vectors then. */
static inline $real reduce($real *row, uint32_t k, $real reciprocal, const lanes_t *top, $real beside)
{
    const $real multiplier = row[k] * reciprocal;
    const $real next = row[k + 1U] + multiplier * beside;
    add(row, multiplier, top, 0U);
    row[k] = multiplier + $zero;
    return next;
}

/* A step of the elimination. Gives the next pivot: the first of the largest magnitudes. */
static inline __attribute__((always_inline)) candidate_t eliminate_by($real *rows, uint32_t *order, const uint32_t k,
    candidate_t pivot)
{
    $real *const top = &rows[PITCH * k];
    lanes_t parts[PARTS];
#pragma GCC unroll 16
    for (uint32_t part = 0U; part < PARTS; part++) {
        parts[part] = *(const lanes_t *)&rows[PITCH * pivot.row + LANES * part];
    }
    if (pivot.row != k) {
        exchange_parts(top, &rows[PITCH * pivot.row], parts, 0U);
        const uint32_t column = order[k];
        order[k] = order[pivot.row];
        order[pivot.row] = column;
    }
    const $real reciprocal = -$one / top[k];
    const $real beside = top[k + 1U];
    candidate_t next = {k + 1U, $abs(reduce(&top[PITCH], k, reciprocal, parts, beside))};
$unroll    for (uint32_t row = k + 2U; row < $n; row++) {
        prefer(&next, row, reduce(&rows[PITCH * row], k, reciprocal, parts, beside));
    }
    return next;
}

/* Solves for a row, by U and the rows below it. Adds what it has become to sums. */
static inline __attribute__((always_inline)) void substitute_row($real *rows, const uint32_t row, lanes_t *sums)
{
    $real *const own = &rows[PITCH * row];
    lanes_t solved[PARTS];
#pragma GCC unroll 16
    for (uint32_t part = 0U; part < PARTS; part++) {
        const uint32_t from = PITCH + LANES * part - row;
        const words_t kept = (words_t) * (const lanes_t *)&own[LANES * part] & *(const words_t *)&KEPT[from];
        solved[part] = (lanes_t)(kept | *(const words_t *)&UNIT[from]);
    }
$unroll    for (uint32_t k = $n - 1U; k > row; k--) {
        const $real multiplier = own[k];
#pragma GCC unroll 16
        for (uint32_t part = 0U; part < PARTS; part++) {
            solved[part] -= multiplier * *(const lanes_t *)&rows[PITCH * k + LANES * part];
        }
    }
    const $real diagonal = own[row];
#pragma GCC unroll 16
    for (uint32_t part = 0U; part < PARTS; part++) {
        solved[part] /= diagonal;
        sums[part] += solved[part];
        *(lanes_t *)&own[LANES * part] = solved[part];
    }
}

/* Whether every number that was added is finite. */
static inline bool are_finite(const lanes_t *sums)
{
    lanes_t sum = sums[0];
#pragma GCC unroll 16
    for (uint32_t part = 1U; part < PARTS; part++) {
        sum += sums[part];
    }
    bool finite = true;
#pragma GCC unroll 16
    for (uint32_t lane = 0U; lane < LANES; lane++) {
        finite = finite && sum[lane] - sum[lane] == $zero;
    }
    return finite;
}

$give/* False if there is no inverse. Says whether all of its numbers are finite; if not, it is not written: what was left
   out, zeros times multipliers, may have been no zeros. */
static bool invert_by_rows($real *a, $real *rows, bool *finite)
{
    uint32_t order[$n];
    for (uint32_t k = 0U; k < $n; k++) {
        order[k] = k;
    }
    bring_rows(rows, a);
    candidate_t pivot = find_first(a);
$steps    if (pivot.magnitude == $zero) {
        return false;
    }
    lanes_t sums[PARTS];
#pragma GCC unroll 16
    for (uint32_t part = 0U; part < PARTS; part++) {
        const lanes_t zeros = {$zero};
        sums[part] = zeros;
    }
$upwards    *finite = are_finite(sums);
    if (*finite) {
        give_rows(a, rows, order);
    }
    return true;
}
