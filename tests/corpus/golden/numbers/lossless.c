/* The C of tests/corpus/src/programs/numbers/lossless.rs. Written by a test. */

/* lossless.c */

int64_t lossless_total(uint8_t a, int16_t b, uint32_t c)
{
    return (int64_t)a + (int64_t)b + (int64_t)c;
}

double lossless_ratio(float a, uint32_t b)
{
    return (double)a / (double)b;
}
