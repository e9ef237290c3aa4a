for (uint32_t column = $first; column < $n; column += 4U) {
    $real *const top = &$l[column + $n * column];
    /* What is above the diagonal stays as it is. */
    const $real above[6] = {
        top[$n], top[2U * $n], top[2U * $n + 1U], top[3U * $n], top[3U * $n + 1U], top[3U * $n + 2U]};
    take(top, &$l[column], &$l[column], column, top);
    top[$n] = above[0];
    top[2U * $n] = above[1];
    top[2U * $n + 1U] = above[2];
    top[3U * $n] = above[3];
    top[3U * $n + 1U] = above[4];
    top[3U * $n + 2U] = above[5];
    if (!factor_top(top)) {
        $none
    }
    for (uint32_t row = column + 4U; row < $n; row += 4U) {
        take(&$l[row + $n * column], &$l[row], &$l[column], column, top);
    }
}
$done