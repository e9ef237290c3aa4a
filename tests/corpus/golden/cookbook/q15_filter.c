/* The C of tests/corpus/src/programs/cookbook/q15_filter.rs. Written by a test. */

/* q15_filter.c */

void q15_mul(const q15_t *self, const q15_t *other, q15_t *BESSEMER_RESTRICT q15)
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

void q15_low_pass_init(q15_low_pass_t *self)
{
    self->level = 0;
}

void q15_low_pass_step(q15_low_pass_t *BESSEMER_RESTRICT self, const q15_t *gain,
    const q15_t *share, const q15_t *sample, q15_t *BESSEMER_RESTRICT q15)
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

/** A first-order low-pass. */
typedef struct {
    /** The output, with 30 fractional bits. */
    int32_t level;
} q15_low_pass_t;
