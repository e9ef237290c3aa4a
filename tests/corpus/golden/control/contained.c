/* The C of tests/corpus/src/programs/control/contained.rs. Written by a test. */

/* contained.c */

/* The signed integer with these bits. */
static int32_t wrap_i32(uint32_t bits)
{
    return bits <= (uint32_t)INT32_MAX ? (int32_t)bits : -1 - (int32_t)(UINT32_MAX - bits);
}

/* a + b, or the limit of the type beyond which it lies. */
static int32_t saturating_add_i32(int32_t a, int32_t b)
{
    const int64_t exact = (int64_t)a + (int64_t)b;
    if (exact < INT32_MIN) {
        return INT32_MIN;
    }
    return exact > INT32_MAX ? INT32_MAX : (int32_t)exact;
}

void contained_share(float x, option_f32_t *result)
{
    if (0.0F <= x && x <= 1.0F) {
        result->is_some = true;
        result->value = x;
    } else {
        result->is_some = false;
        result->value = 0.0F;
    }
}

void contained_inside(int32_t low, int32_t width, int32_t x, option_i32_t *result)
{
    const int32_t high = saturating_add_i32(low, width);
    if (low <= x && x < high) {
        result->is_some = true;
        result->value = wrap_i32((uint32_t)x - (uint32_t)(low / 2 + high / 2));
    } else {
        result->is_some = false;
        result->value = 0;
    }
}
