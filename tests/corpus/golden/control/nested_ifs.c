/* The C of tests/corpus/src/programs/control/nested_ifs.rs. Written by a test. */

/* nested_ifs.c */

uint16_t nested_ifs_current(uint16_t voltage, int8_t temperature, bool fast)
{
    uint16_t current = 500U;
    if (temperature > 0) {
        if (temperature < 45) {
            if (fast) {
                current = 2000U;
            } else {
                current = 1000U;
            }
        }
    } else {
        current = 0U;
    }
    if (voltage > 4200U) {
        current = (uint16_t)(current / 4U);
    }
    return current;
}
