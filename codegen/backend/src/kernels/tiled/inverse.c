$real *const tiles = aligned(tile_memory);
$real *const panel = aligned(panel_memory);
bool finite = true;
if (!factor(a, tiles, panel, pivots, &finite)) {
    return false;
}
/* Right-hand sides in the order of the pivots: of row k, the column order[k] of the identity. */
for (uint32_t k = 0U; k < SIZE; k++) {
    order[k] = k;
}
for (uint32_t k = 0U; k < SIZE; k++) {
    const uint32_t column = order[k];
    order[k] = order[pivots[k]];
    order[pivots[k]] = column;
}
$panels
return true;
