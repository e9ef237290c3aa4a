/* The C of tests/corpus/src/programs/cookbook/q15_filter.rs. Written by a test. */

/* q15_filter.c */

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

/* The smaller of two integers. */
static int32_t min_i32(int32_t a, int32_t b)
{
    return a < b ? a : b;
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

void q15_mul(const q15_t *self, const q15_t *other, q15_t *q15)
{
    const int32_t wide = shift_right_i32(
        (int32_t)self->value * (int32_t)other->value + shift_left_i32(1, 14U), 15U);
    q15->value = wrap_i16((uint16_t)min_i32(wide, 32767));
}

/* q15_filter.h */

/** A number from -1 to 1 - 2⁻¹⁵, in steps of 2⁻¹⁵. */
typedef struct {
    int16_t value;
} q15_t;

/* q15_low_pass.c */

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

/* The signed integer with these bits. */
static int64_t wrap_i64(uint64_t bits)
{
    return bits <= (uint64_t)INT64_MAX ? (int64_t)bits : -1 - (int64_t)(UINT64_MAX - bits);
}

/* The smaller of two integers. */
static int32_t min_i32(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* The larger of two integers. */
static int16_t max_i16(int16_t a, int16_t b)
{
    return a > b ? a : b;
}

/* The number nearest to value from low to high. */
static int64_t clamp_i64(int64_t value, int64_t low, int64_t high)
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

/* The bits of value shifted left by count, which is less than 64. */
static int64_t shift_left_i64(int64_t value, uint32_t count)
{
    return wrap_i64((uint64_t)value << count);
}

/* value divided by 2^count and rounded down; count is less than 32. */
static int32_t shift_right_i32(int32_t value, uint32_t count)
{
    return value < 0 ? ~(~value >> count) : value >> count;
}

/* value divided by 2^count and rounded down; count is less than 64. */
static int64_t shift_right_i64(int64_t value, uint32_t count)
{
    return value < 0 ? ~(~value >> count) : value >> count;
}

void q15_low_pass_init(q15_low_pass_t *self)
{
    self->level = 0;
}

void q15_low_pass_step(q15_low_pass_t *self, const q15_t *gain, const q15_t *share,
    const q15_t *sample, q15_t *q15)
{
    q15_t q15_value;
    q15_mul(gain, sample, &q15_value);
    const int64_t target = shift_left_i64((int64_t)q15_value.value, 15U);
    const int64_t way = (target - (int64_t)self->level) * (int64_t)max_i16(share->value, 0);
    const int64_t level = (int64_t)self->level + shift_right_i64(way, 15U);
    self->level = wrap_i32((uint32_t)clamp_i64(level, -shift_left_i64(INT64_C(1), 30U),
        shift_left_i64(INT64_C(1), 30U) - INT64_C(1)));
    q15->value = wrap_i16((uint16_t)min_i32(
        shift_right_i32(self->level + shift_left_i32(1, 14U), 15U), 32767));
}

/* q15_low_pass.h */

/** A low-pass of first order. */
typedef struct {
    /** The output with 30 bits behind the point. */
    int32_t level;
} q15_low_pass_t;
