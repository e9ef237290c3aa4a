/* The C of tests/corpus/src/programs/numbers/saturating.rs. Written by a test. */

/* saturating.c */

int16_t saturating_integrated(int16_t sum, int16_t error)
{
    return saturating_add_i16(sum, saturating_mul_i16(error, 3));
}
