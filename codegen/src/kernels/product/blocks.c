/* The last blocks overlap the ones before, where the result is no multiple of them. */
for (uint32_t column = $begin; column < $columns; column += $apart_columns) {
    const uint32_t left = (column + ACROSS <= $columns) ? column : $columns - ACROSS;
    for (uint32_t row = 0U; row < $rows; row += HEIGHT) {
        const uint32_t top = (row + HEIGHT <= $rows) ? row : $rows - HEIGHT;
        block(&a[$top], &b[$left], &result[top + $rows * left]);
    }
}
