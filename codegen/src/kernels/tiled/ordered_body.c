$real *const panel = aligned(panel_memory);
const elimination_t elimination = {aligned(tile_memory), panel, &panel[WIDTH * ROWS],
    &panel[WIDTH * (ROWS + BLOCK)], pivots, &pivots[ROWS]};
for (uint32_t row = 0U; row < ROWS; row++) {
    elimination.order[row] = row;
    elimination.place[row] = row;
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
