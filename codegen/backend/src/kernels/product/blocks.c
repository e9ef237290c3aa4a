/* Where the rows are no multiple of a band, the last overlaps the one before. */
for (uint32_t row = 0U; row < $end; row += HEIGHT) {
    const uint32_t top = (row + HEIGHT <= $banded) ? row : $banded - HEIGHT;
    band(&a[$top], b, &result[top], COLUMNS, VECTORS$share);
}
#if defined(LAST_VECTORS)
band(&a[$at_end], b, &result[END], LAST_COLUMNS, LAST_VECTORS$share);
#endif
#if defined(LAST_ROW_COLUMNS)
$last_alone#endif
