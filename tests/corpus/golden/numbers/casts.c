/* The C of tests/corpus/src/programs/numbers/casts.rs. Written by a test. */

/* casts.c */

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
