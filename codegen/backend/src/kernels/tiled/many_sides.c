for (uint32_t begin = $begin; begin < $columns; begin += $apart) {
    for (uint32_t row = 0U; row < ROWS; row++) {
        for (uint32_t lane = 0U; lane < WIDTH; lane++) {
            const bool there = row < SIZE && begin + lane < $columns;
            panel[WIDTH * row + lane] = there ? b[row + SIZE * (begin + lane)] : $zero;
        }
    }
    for (uint32_t row = 0U; row < SIZE; row++) {
        exchange_rows(&panel[WIDTH * row], &panel[WIDTH * pivots[row]]);
    }
    solve_panel(tiles, panel, 0U, ROWS, panel);
    for (uint32_t lane = 0U; lane < WIDTH && begin + lane < $columns; lane++) {
        for (uint32_t row = 0U; row < SIZE; row++) {
            b[row + SIZE * (begin + lane)] = panel[WIDTH * row + lane];
        }
    }
}
