$real *const panel = aligned(panel_memory);
$real *const block = &panel[WIDTH * ROWS];
const elimination_t elimination = {
    aligned(tile_memory), panel, block, &block[WIDTH * BLOCK], pivots, &pivots[ROWS]};
begin(&elimination);
for (uint32_t row = 0U; row < ROWS + GROUP; row++) {
    elimination.x[row] = (row < SIZE) ? b[row] : $zero;
}
if (!eliminate_all(&elimination, a)) {
    for (uint32_t row = 0U; row < SIZE; row++) {
        b[row] = $nan;
    }
    return false;
}
substitute(&elimination);
(void)memcpy(b, elimination.x, SIZE * sizeof(*b));
return true;
