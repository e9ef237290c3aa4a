/* The C of tests/corpus/src/programs/control/match_ranges.rs. Written by a test. */

/* match_ranges.c */

uint8_t match_ranges_power(int16_t temperature, bool boosted)
{
    const int16_t t = temperature;
    if (t <= -20) {
        return 0U;
    } else if (t >= -19 && t <= 60) {
        return 100U;
    } else if (t >= 61 && t <= 80 && boosted) {
        return 90U;
    } else if (t >= 61 && t <= 80) {
        return 70U;
    } else if (t < 100) {
        return 20U;
    } else {
        return 0U;
    }
}
