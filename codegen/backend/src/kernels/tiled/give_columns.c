/* Writes four columns of a panel to their columns of the matrix. */
static void give_columns($real *a, const $real *panel, const uint32_t *order)
{
    $real *first = &a[SIZE * order[0]];
    $real *second = &a[SIZE * order[1]];
    $real *third = &a[SIZE * order[2]];
    $real *fourth = &a[SIZE * order[3]];
    for (uint32_t row = 0U; row < SIZE; row++) {
        const four_t four = load_four(&panel[WIDTH * row]);
        *first++ = four.a;
        *second++ = four.b;
        *third++ = four.c;
        *fourth++ = four.d;
    }
}
