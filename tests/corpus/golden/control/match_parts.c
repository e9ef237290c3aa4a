/* The C of tests/corpus/src/programs/control/match_parts.rs. Written by a test. */

/* match_parts.c */

uint8_t match_parts_action(const match_parts_key_t *key, bool shift)
{
    if (!key->held.is_some) {
        return 0U;
    } else if (key->code >= 65U && key->code <= 90U && key->held.value <= 9U && !shift) {
        return 1U;
    } else if (shift && key->held.value > 100U) {
        return key->code;
    } else {
        return 2U;
    }
}

float match_parts_length(const match_parts_stretch_t *stretch)
{
    switch (stretch->tag) {
    case STRETCH_TAG_POINT:
        return 0.0F;
    case STRETCH_TAG_BETWEEN:
        return stretch->as.between.second - stretch->as.between.first;
    case STRETCH_TAG_AROUND:
    default:
        return 2.0F * stretch->as.around.half;
    }
}

/* match_parts.h */

/** A key and how long it has been pressed. */
typedef struct {
    uint8_t code;
    option_u16_t held;
} match_parts_key_t;

/** Which variant of `Stretch`. */
typedef enum {
    STRETCH_TAG_POINT = 0,
    STRETCH_TAG_BETWEEN = 1,
    STRETCH_TAG_AROUND = 2
} stretch_tag_t;

/** Fields of the variant Around of Stretch. */
typedef struct {
    float centre;
    float half;
} stretch_around_t;

/** A segment of a line. */
typedef struct {
    /** Which variant it is. */
    stretch_tag_t tag;
    /** What it holds. */
    union {
        float point;
        pair_f32_f32_t between;
        stretch_around_t around;
    } as;
} match_parts_stretch_t;
