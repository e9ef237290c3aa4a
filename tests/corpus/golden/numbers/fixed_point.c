/* The C of tests/corpus/src/programs/numbers/fixed_point.rs. Written by a test. */

/* fixed_point.c */

int16_t fixed_point_product(int16_t a, int16_t b)
{
    const int32_t wide = shift_right_i32((int32_t)a * (int32_t)b + shift_left_i32(1, 14U), 15U);
    return wrap_i16((uint16_t)clamp_i32(wide, -32768, 32767));
}
