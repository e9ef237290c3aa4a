/* The C of tests/corpus/src/programs/control/contained.rs. Written by a test. */

/* contained.c */

void contained_share(float x, option_f32_t *result)
{
    if (0.0F <= x && x <= 1.0F) {
        result->is_some = true;
        result->value = x;
    } else {
        *result = (option_f32_t){.is_some = false};
    }
}

void contained_inside(int32_t low, int32_t width, int32_t x, option_i32_t *result)
{
    const int32_t high = saturating_add_i32(low, width);
    if (low <= x && x < high) {
        result->is_some = true;
        result->value = wrap_i32((uint32_t)x - u32_from_i32(low / 2 + high / 2));
    } else {
        *result = (option_i32_t){.is_some = false};
    }
}
