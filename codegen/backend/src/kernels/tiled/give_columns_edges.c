/* Writes up to four columns of a panel to their columns of the matrix. */
static void give_columns($real *a, const $real *panel, const uint32_t *order, uint32_t columns)
{
    for (uint32_t lane = 0U; lane < columns; lane++) {
        $real *const column = &a[SIZE * order[lane]];
        for (uint32_t row = 0U; row < SIZE; row++) {
            column[row] = panel[WIDTH * row + lane];
        }
    }
}
