$real *const panel = aligned(panel_memory);
$real *const block = &panel[WIDTH * TALL_ROWS];
const elimination_t elimination = {
    aligned(tile_memory), panel, block, &block[WIDTH * BLOCK], pivots, &pivots[TALL_ROWS]};
for (uint32_t row = 0U; row < TALL_ROWS; row++) {
    elimination.order[row] = (row < ROWS) ? row : 0U;
}
for (uint32_t row = 0U; row < ROWS; row++) {
    elimination.place[row] = row;
}
for (uint32_t index = WIDTH * ROWS; index < WIDTH * TALL_ROWS; index++) {
    panel[index] = $zero;
}
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
memcpy(b, elimination.x, SIZE * sizeof(*b));
return true;
