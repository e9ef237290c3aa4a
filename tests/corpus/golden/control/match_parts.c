/* The C of tests/corpus/src/programs/control/match_parts.rs. Written by a test. */

/* match_parts.c */

uint8_t match_parts_action(const match_parts_key_t *key, bool shift)
{
    if (!key->held.is_some) {
        return 0U;
    } else if (key->code >= 65U && key->code <= 90U && (key->held.is_some && key->held.value <= 9U)
            && !shift) {
        return 1U;
    } else if (key->held.is_some && shift && key->held.value > 100U) {
        return key->code;
    } else {
        return 2U;
    }
}

/* match_parts.h */

/** A key, and for how long it has been down. */
typedef struct {
    uint8_t code;
    option_u16_t held;
} match_parts_key_t;
