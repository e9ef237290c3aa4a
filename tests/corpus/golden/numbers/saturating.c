/* The C of tests/corpus/src/programs/numbers/saturating.rs. Written by a test. */

/* saturating.c */

/* a + b, or the limit of the type beyond which it lies. */
static int16_t saturating_add_i16(int16_t a, int16_t b)
{
    const int32_t exact = (int32_t)a + (int32_t)b;
    if (exact < INT16_MIN) {
        return INT16_MIN;
    }
    return exact > INT16_MAX ? INT16_MAX : (int16_t)exact;
}

/* a * b, or the limit of the type beyond which it lies. */
static int16_t saturating_mul_i16(int16_t a, int16_t b)
{
    const int32_t exact = (int32_t)a * (int32_t)b;
    if (exact < INT16_MIN) {
        return INT16_MIN;
    }
    return exact > INT16_MAX ? INT16_MAX : (int16_t)exact;
}

int16_t saturating_integrated(int16_t sum, int16_t error)
{
    return saturating_add_i16(sum, saturating_mul_i16(error, 3));
}
