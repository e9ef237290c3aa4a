/* The last row, which fills no vector: the first product, then the others in order. */
static inline $real last_number(const $real *a, const $real *b)
{
    $real sum = a[0] * b[0];
$alone_unrolled    for (uint32_t k = 1U; k < $inner; k++) {
        sum += a[$next_a] * b[$next_b];
    }
    return sum;
}
