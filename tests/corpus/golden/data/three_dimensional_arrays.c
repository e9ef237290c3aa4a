/* The C of tests/corpus/src/programs/data/three_dimensional_arrays.rs. Written by a test. */

/* three_dimensional_arrays.c */

uint32_t three_dimensional_arrays_taken(const bool grid[2][3][4])
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < 2U; i++) {
        for (uint32_t j = 0U; j < 3U; j++) {
            for (uint32_t k = 0U; k < 4U; k++) {
                if (grid[i][j][k]) {
                    count += 1U;
                }
            }
        }
    }
    return count;
}
