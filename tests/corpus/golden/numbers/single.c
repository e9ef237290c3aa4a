/* The C of tests/corpus/src/programs/numbers/single.rs. Written by a test. */

/* programs_numbers_single.c */

float programs_numbers_single_corrected(float x)
{
    const float y = 0.25F * x * x - 1.5F * x + 0.1F;
    return sqrtf(y * y + 1.0F);
}
