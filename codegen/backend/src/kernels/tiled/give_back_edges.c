/* Writes the factors to the matrix, by columns. */
NOT_INLINE static void give_back($real *a, const $real *tiles)
{
    for (uint32_t column = 0U; column < SIZE; column++) {
        for (uint32_t row = 0U; row < SIZE; row++) {
            a[SIZE * column + row] = tiles[place(row - row % 4U, column) + row % 4U];
        }
    }
}
