/* The C of tests/corpus/src/programs/control/labels.rs. Written by a test. */

/* labels.c */

uint32_t labels_rows_without_gap(const uint8_t grid[3][4])
{
    uint32_t rows = 0U;
    for (uint32_t i = 0U; i < 3U; i++) {
        bool rows_next = false;
        bool rows_done = false;
        for (uint32_t j = 0U; j < 4U; j++) {
            if (grid[i][j] == 0U) {
                rows += 1U;
                rows_next = true;
                break;
            }
            if (grid[i][j] == 255U) {
                rows_done = true;
                break;
            }
        }
        if (rows_next) {
            continue;
        }
        if (rows_done) {
            break;
        }
        rows += 1U;
    }
    return rows;
}
