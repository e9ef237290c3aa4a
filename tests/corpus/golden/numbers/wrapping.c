/* The C of tests/corpus/src/programs/numbers/wrapping.rs. Written by a test. */

/* wrapping.c */

uint32_t wrapping_next(uint32_t seed)
{
    return seed * 0x19660DU + 0x3C6EF35FU;
}

int32_t wrapping_elapsed(uint32_t now, uint32_t then)
{
    return wrap_i32(now - then);
}
