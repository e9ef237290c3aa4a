for (uint32_t column = $first_column; column < $columns; $next_column) {
    for (uint32_t row = 0U; row < $rows; row += HEIGHT) {
        const uint32_t top = (row + HEIGHT <= $rows) ? row : $rows - HEIGHT;
        column_part(&a[top], &b[$inner * column], &result[top + $rows * column]);
    }
}
