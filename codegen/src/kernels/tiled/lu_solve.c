$real *const tiles = aligned(tile_memory);
$real *const panel = aligned(panel_memory);
bool finite = true;
if (!factor(a, tiles, panel, pivots, &finite)) {
    for (uint32_t index = 0U; index < SIZE * SIZE; index++) {
        a[index] = $nan;
    }
    for (uint32_t index = 0U; index < SIZE * $columns; index++) {
        b[index] = $nan;
    }
    return false;
}
$substitute
give_back(a, tiles);
return true;
