/* The C of tests/corpus/src/programs/control/match_ranges.rs. Written by a test. */

/* match_ranges.c */

uint8_t match_ranges_power(int16_t temperature, bool boosted)
{
    if (temperature <= -20) {
        return 0U;
    } else if (temperature <= 60) {
        return 100U;
    } else if (temperature <= 80 && boosted) {
        return 90U;
    } else if (temperature <= 80) {
        return 70U;
    } else if (temperature < 100) {
        return 20U;
    } else {
        return 0U;
    }
}
