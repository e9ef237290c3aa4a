/* The C of tests/corpus/src/programs/numbers/checked_results.rs. Written by a test. */

/* checked_results.c */

void checked_results_area(uint16_t width, uint16_t height, option_u16_t *result)
{
    math_checked_mul_u16(width, height, result);
}

int32_t checked_results_distance(int32_t from, int32_t to)
{
    option_i32_t option;
    math_checked_sub_i32(to, from, &option);
    int32_t result = 0;
    if (option.is_some) {
        result = option.value;
    }
    return result;
}
