/* The C of tests/corpus/src/programs/control/short_circuit.rs. Written by a test. */

/* short_circuit.c */

bool short_circuit_divides(uint32_t n, uint32_t divisor)
{
    return divisor != 0U && n % divisor == 0U;
}

bool short_circuit_unusable(const int32_t values[3], uint64_t at)
{
    return at >= UINT64_C(3) || values[at] > 100;
}
