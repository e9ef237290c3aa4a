/* The C of tests/corpus/src/programs/numbers/remainders.rs. Written by a test. */

/* remainders.c */

static const double TAU = 6.283185307179586;

int32_t remainders_in_ring(int32_t place, int8_t step)
{
    return rem_euclid_i32((place % 12) + (int32_t)step, 12);
}

double remainders_wrapped(double angle)
{
    return rem_euclid_f64(angle, TAU);
}
