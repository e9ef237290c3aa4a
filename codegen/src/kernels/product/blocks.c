/* Where the rows are no multiple of a band, the last overlaps the one before. */
for (uint32_t row = 0U; row < $end; row += HEIGHT) {
    const uint32_t top = (row + HEIGHT <= $banded) ? row : $banded - HEIGHT;
    band(&a[$top], b, &result[top], ACROSS, DOWN$share);
}
#if defined(LAST_DOWN)
band(&a[$at_end], b, &result[END], LAST_ACROSS, LAST_DOWN$share);
#endif
#if defined(ALONE)
$last_alone#endif
