/* Takes the row of a pivot from a row below it, and from its right-hand side. Gives the number in the next
   column: computed by itself, for the next pivot does not wait for the vectors then. */
static inline __attribute__((always_inline)) $real reduce($real *row, $real *side, uint32_t k, $real reciprocal,
    const lanes_t *top, $real beside, $real known, const uint32_t first)
{
    const $real multiplier = row[FIRST + k] * reciprocal;
    const $real next = row[FIRST + k + 1U] + multiplier * beside;
    add(row, multiplier, top, first);
    *side += multiplier * known;
    return next;
}

/* A step of the elimination. Gives the next pivot: the first of the largest magnitudes. Nothing is left below the
   diagonal that counts. */
static inline __attribute__((always_inline)) candidate_t eliminate_by($real *rows, $real *b, const uint32_t k,
    candidate_t pivot)
{
    /* The vectors with the columns from k on, and from the next on. */
    const uint32_t own = (FIRST + k) / LANES;
    const uint32_t first = (FIRST + k + 1U) / LANES;
    $real *const top = &rows[PITCH * k];
    lanes_t parts[PARTS];
#pragma GCC unroll 16
    for (uint32_t part = own; part < PARTS; part++) {
        parts[part] = *(const lanes_t *)&rows[PITCH * pivot.row + LANES * part];
    }
    const $real known = b[pivot.row];
    if (pivot.row != k) {
        exchange_parts(top, &rows[PITCH * pivot.row], parts, own);
        b[pivot.row] = b[k];
        b[k] = known;
    }
    const $real reciprocal = -$one / top[FIRST + k];
    const $real beside = top[FIRST + k + 1U];
    const $real below = reduce(&top[PITCH], &b[k + 1U], k, reciprocal, parts, beside, known, first);
    candidate_t next = {k + 1U, $abs(below)};
$unroll    for (uint32_t row = k + 2U; row < $n; row++) {
        const $real number = reduce(&rows[PITCH * row], &b[row], k, reciprocal, parts, beside, known, first);
        prefer(&next, row, number);
    }
    return next;
}

/* Eliminates below the diagonal, the right-hand side along with it; then upwards by U. False if a pivot is
   zero. */
static bool solve_by_rows(const $real *a, $real *b, $real *rows)
{
    bring_rows(rows, a);
    candidate_t pivot = find_first(a);
$steps    if (pivot.magnitude == $zero) {
        return false;
    }
$upwards    return true;
}
