/* The C of tests/corpus/src/programs/control/loops_in_loops.rs. Written by a test. */

/* loops_in_loops.c */

void loops_in_loops_sorted(const int16_t values[5], int16_t result[BESSEMER_RESTRICT 5])
{
    int16_t own_values[5];
    (void)memcpy(own_values, values, sizeof(int16_t[5]));
    for (uint32_t end = 1U; end < 5U; end++) {
        for (uint32_t i = end; i-- > 0U;) {
            if (own_values[i] > own_values[i + 1U]) {
                const int16_t larger = own_values[i];
                own_values[i] = own_values[i + 1U];
                own_values[i + 1U] = larger;
            }
        }
    }
    (void)memcpy(result, own_values, sizeof(int16_t[5]));
}
