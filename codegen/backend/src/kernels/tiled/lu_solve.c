$real *const tiles = aligned(tile_memory);
$real *const panel = aligned(panel_memory);
bool finite = true;
if (!factor(a, tiles, panel, pivots, &finite)) {
$spoil    for (uint32_t index = 0U; index < SIZE * $columns; index++) {
        b[index] = $nan;
    }
    return false;
}
$substitute
$give_backreturn true;
