/* The C of tests/corpus/src/programs/numbers/rotations.rs. Written by a test. */

/* rotations.c */

uint32_t rotations_mixed(uint32_t hash, uint32_t word)
{
    return (((hash << 5U) | (hash >> 27U)) ^ word) * 0x9E3779B9U;
}

uint32_t rotations_turned(uint32_t word)
{
    return swap_bytes_u32(word);
}
