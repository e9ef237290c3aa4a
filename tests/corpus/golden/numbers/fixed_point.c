/* The C of tests/corpus/src/programs/numbers/fixed_point.rs. Written by a test. */

/* fixed_point.c */

/* The signed integer with these bits. */
static int16_t wrap_i16(uint16_t bits)
{
    return bits <= (uint16_t)INT16_MAX ? (int16_t)bits : (int16_t)(-1 - (int16_t)(UINT16_MAX - bits));
}

/* The signed integer with these bits. */
static int32_t wrap_i32(uint32_t bits)
{
    return bits <= (uint32_t)INT32_MAX ? (int32_t)bits : -1 - (int32_t)(UINT32_MAX - bits);
}

/* The number nearest to value from low to high. */
static int32_t clamp_i32(int32_t value, int32_t low, int32_t high)
{
    if (value < low) {
        return low;
    }
    return value > high ? high : value;
}

/* The bits of value shifted left by count, which is less than 32. */
static int32_t shift_left_i32(int32_t value, uint32_t count)
{
    return wrap_i32((uint32_t)value << count);
}

/* value divided by 2^count and rounded down; count is less than 32. */
static int32_t shift_right_i32(int32_t value, uint32_t count)
{
    return value < 0 ? ~(~value >> count) : value >> count;
}

int16_t fixed_point_product(int16_t a, int16_t b)
{
    const int32_t wide = shift_right_i32((int32_t)a * (int32_t)b + shift_left_i32(1, 14U), 15U);
    return wrap_i16((uint16_t)clamp_i32(wide, -32768, 32767));
}
