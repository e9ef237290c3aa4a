$real *const x = panel;
(void)memcpy(x, b, SIZE * sizeof(*x));
for (uint32_t row = 0U; row < SIZE; row++) {
    exchange_numbers(&x[row], &x[pivots[row]]);
}
$pad_x
forward(tiles, x);
$pad_x
backward(tiles, x);
(void)memcpy(b, x, SIZE * sizeof(*x));
