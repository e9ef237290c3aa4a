$real *const panel = aligned(panel_memory);
const elimination_t whole = {aligned(tile_memory), panel, &panel[WIDTH * ROWS], order, pivots};
const elimination_t *const elimination = &whole;
begin(elimination);
if (!eliminate_all(elimination, a)) {
    return false;
}
#if defined(EDGE)
pad(elimination);
#endif
const bool finite = all_finite(elimination);
$panels
return true;
