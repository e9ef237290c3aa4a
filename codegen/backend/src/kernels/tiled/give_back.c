static inline void copy_four($real *to, const $real *from)
{
#if defined(WORDS)
    vst4_s64((word_t *)to, vld4_s64((const word_t *)from));
#else
    (void)memcpy(to, from, 4U * sizeof(*to));
#endif
}

/* Writes the factors to the matrix, by columns. */
NOT_INLINE static void give_back($real *a, const $real *tiles)
{
    for (uint32_t column = 0U; column < SIZE; column += 4U) {
        const $real *tile = &tiles[place(0U, column)];
        $real *first = &a[SIZE * column];
        $real *second = &first[SIZE];
        $real *third = &second[SIZE];
        $real *fourth = &third[SIZE];
        for (uint32_t row = 0U; row < SIZE; row += 4U) {
            copy_four(first, &tile[0]);
            copy_four(second, &tile[4]);
            copy_four(third, &tile[8]);
            copy_four(fourth, &tile[12]);
            first += 4;
            second += 4;
            third += 4;
            fourth += 4;
            tile += TILE;
        }
    }
}
