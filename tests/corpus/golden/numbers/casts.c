/* The C of tests/corpus/src/programs/numbers/casts.rs. Written by a test. */

/* casts.c */

/* The signed integer with these bits. */
static int8_t wrap_i8(uint8_t bits)
{
    return bits <= (uint8_t)INT8_MAX ? (int8_t)bits : (int8_t)(-1 - (int8_t)(UINT8_MAX - bits));
}

/* The integer nearest to value towards zero, within its type; 0 for a NaN. */
static int64_t i64_from_f32(float value)
{
    if (isnan(value)) {
        return 0;
    }
    if (value <= -9223372036854775808.0F) {
        return INT64_MIN;
    }
    return value >= 9223372036854775808.0F ? INT64_MAX : (int64_t)value;
}

/* The integer nearest to value towards zero, within its type; 0 for a NaN. */
static uint16_t u16_from_f64(double value)
{
    if (isnan(value)) {
        return 0;
    }
    if (value <= 0.0) {
        return 0;
    }
    return value >= 65536.0 ? UINT16_MAX : (uint16_t)value;
}

uint16_t casts_counts(double duty)
{
    return u16_from_f64(duty * 1023.0);
}

int8_t casts_low_byte(uint32_t word)
{
    return wrap_i8((uint8_t)word);
}

int64_t casts_through_float(int64_t n)
{
    return i64_from_f32((float)n);
}
