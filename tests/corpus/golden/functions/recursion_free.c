/* The C of tests/corpus/src/programs/functions/recursion_free.rs. Written by a test. */

/* recursion_free.c */

uint64_t recursion_free_ways(uint8_t steps)
{
    uint64_t before = UINT64_C(0);
    uint64_t ways = UINT64_C(1);
    {
        const uint8_t end = min_u8(steps, 90U);
        for (uint8_t pass = 0U; pass < end; pass++) {
            const uint64_t next = ways + before;
            before = ways;
            ways = next;
        }
    }
    return ways;
}
