const four_t a1 = __builtin_shufflevector(row1, row1, 1, 0, 0, 0);
const four_t b1 = __builtin_shufflevector(row1, row1, 2, 2, 1, 1);
const four_t c1 = __builtin_shufflevector(row1, row1, 3, 3, 3, 2);
const four_t a2 = __builtin_shufflevector(row2, row2, 1, 0, 0, 0);
const four_t b2 = __builtin_shufflevector(row2, row2, 2, 2, 1, 1);
const four_t c2 = __builtin_shufflevector(row2, row2, 3, 3, 3, 2);
const four_t a3 = __builtin_shufflevector(row3, row3, 1, 0, 0, 0);
const four_t b3 = __builtin_shufflevector(row3, row3, 2, 2, 1, 1);
const four_t c3 = __builtin_shufflevector(row3, row3, 3, 3, 3, 2);
/* The signs of the cofactors go to the first factors: all that follows is as it would be without. */
const four_t signs = {$one, -$one, $one, -$one};
const four_t a0 = __builtin_shufflevector(row0, row0, 1, 0, 0, 0) * signs;
const four_t b0 = __builtin_shufflevector(row0, row0, 2, 2, 1, 1) * signs;
const four_t c0 = __builtin_shufflevector(row0, row0, 3, 3, 3, 2) * signs;
const four_t d0 = a1 * signs;
const four_t e0 = b1 * signs;
const four_t f0 = c1 * signs;
/* Of -p + q, the order is that of q - p. */
const four_t cofactors0 = d0 * b2 * c3 - d0 * b3 * c2 - e0 * a2 * c3 + e0 * a3 * c2 + f0 * a2 * b3 - f0 * a3 * b2;
const four_t cofactors1 = a0 * b3 * c2 - a0 * b2 * c3 + b0 * a2 * c3 - b0 * a3 * c2 - c0 * a2 * b3 + c0 * a3 * b2;
const four_t cofactors2 = a0 * b1 * c3 - a0 * b3 * c1 - b0 * a1 * c3 + b0 * a3 * c1 + c0 * a1 * b3 - c0 * a3 * b1;
const four_t cofactors3 = a0 * b2 * c1 - a0 * b1 * c2 + b0 * a1 * c2 - b0 * a2 * c1 - c0 * a1 * b2 + c0 * a2 * b1;
const $real determinant = column0[0] * cofactors0[0] + column0[1] * cofactors1[0] + column0[2] * cofactors2[0]
    + column0[3] * cofactors3[0];
if (determinant == $zero) {
    return false;
}
const $real reciprocal = $one / determinant;
*(four_t *)&a[0] = cofactors0 * reciprocal;
*(four_t *)&a[4] = cofactors1 * reciprocal;
*(four_t *)&a[8] = cofactors2 * reciprocal;
*(four_t *)&a[12] = cofactors3 * reciprocal;
return true;
