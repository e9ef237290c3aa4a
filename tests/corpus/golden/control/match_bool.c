/* The C of tests/corpus/src/programs/control/match_bool.rs. Written by a test. */

/* match_bool.c */

uint8_t match_bool_level(bool high, bool inverted)
{
    if (high != inverted) {
        return 1U;
    } else {
        return 0U;
    }
}
