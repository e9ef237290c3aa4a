/* The C of tests/corpus/src/programs/data/generic_enums.rs. Written by a test. */

/* generic_enums.c */

float received_f32_value_or(const received_f32_t *self, float other)
{
    switch (self->tag) {
    case RECEIVED_F32_TAG_NEW:
        return self->as.new_;
    case RECEIVED_F32_TAG_AGAIN:
        return self->as.again.value;
    case RECEIVED_F32_TAG_NOTHING:
    default:
        return other;
    }
}

float generic_enums_middle(const received_f32_t *low, const received_f32_t *high, float otherwise)
{
    return (received_f32_value_or(low, otherwise) + received_f32_value_or(high, otherwise)) / 2.0F;
}

void generic_enums_aged(const received_f64_t *last, received_f64_t *BESSEMER_RESTRICT received)
{
    switch (last->tag) {
    case RECEIVED_F64_TAG_NEW:
        received->tag = RECEIVED_F64_TAG_AGAIN;
        received->as.again.value = last->as.new_;
        received->as.again.age = 1U;
        break;
    case RECEIVED_F64_TAG_AGAIN:
        if (last->as.again.age < 5U) {
            received->tag = RECEIVED_F64_TAG_AGAIN;
            received->as.again.value = last->as.again.value;
            received->as.again.age = last->as.again.age + 1U;
        } else {
            received->tag = RECEIVED_F64_TAG_NOTHING;
        }
        break;
    case RECEIVED_F64_TAG_NOTHING:
    default:
        received->tag = RECEIVED_F64_TAG_NOTHING;
        break;
    }
}

/* generic_enums.h */

/** Fields of the variant Again of Received_f32. */
typedef struct {
    float value;
    uint32_t age;
} received_f32_again_t;

/** Which variant of `Received_f32`. */
typedef enum {
    /** Received for the first time. */
    RECEIVED_F32_TAG_NEW = 0,
    /** Received before: the value and its age in periods. */
    RECEIVED_F32_TAG_AGAIN = 1,
    /** Nothing came. */
    RECEIVED_F32_TAG_NOTHING = 2
} received_f32_tag_t;

/** A received value: new, repeated, or missing. */
typedef struct {
    /** Which variant it is. */
    received_f32_tag_t tag;
    /** What it holds. */
    union {
        /** Received for the first time. */
        float new_;
        /** Received before: the value and its age in periods. */
        received_f32_again_t again;
    } as;
} received_f32_t;

/** Fields of the variant Again of Received_f64. */
typedef struct {
    double value;
    uint32_t age;
} received_f64_again_t;

/** Which variant of `Received_f64`. */
typedef enum {
    /** Received for the first time. */
    RECEIVED_F64_TAG_NEW = 0,
    /** Received before: the value and its age in periods. */
    RECEIVED_F64_TAG_AGAIN = 1,
    /** Nothing came. */
    RECEIVED_F64_TAG_NOTHING = 2
} received_f64_tag_t;

/** A received value: new, repeated, or missing. */
typedef struct {
    /** Which variant it is. */
    received_f64_tag_t tag;
    /** What it holds. */
    union {
        /** Received for the first time. */
        double new_;
        /** Received before: the value and its age in periods. */
        received_f64_again_t again;
    } as;
} received_f64_t;
