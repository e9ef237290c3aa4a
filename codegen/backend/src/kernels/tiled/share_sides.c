/* Solves for panels of right-hand sides: the panel `from`, and every one so far apart. */
static void solve_sides(const $real *tiles, $real *b, const uint32_t *pivots, $real *panel, uint32_t from,
    uint32_t apart)
{
$sides}
