/* The C of tests/corpus/src/programs/control/match_values.rs. Written by a test. */

/* match_values.c */

uint8_t match_values_kind(uint8_t c)
{
    if (c >= 48U && c <= 57U) {
        return 1U;
    } else if (c == 43U || c == 45U) {
        return 2U;
    } else if (c == 32U || c == 9U || c == 10U || c == 13U) {
        return 3U;
    } else {
        return 0U;
    }
}
