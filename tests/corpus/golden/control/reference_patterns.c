/* The C of tests/corpus/src/programs/control/reference_patterns.rs. Written by a test. */

/* reference_patterns.c */

double reference_patterns_valve_advance(reference_patterns_valve_t *self)
{
    switch (self->order.tag) {
    case REFERENCE_PATTERNS_ORDER_TAG_HOLD:
        break;
    case REFERENCE_PATTERNS_ORDER_TAG_OPEN: {
        const double to = self->order.as.open.to;
        self->order.as.open.ramp[0] += 0.5;
        self->open = min_f64(self->open + self->order.as.open.ramp[0], to);
        break;
    }
    case REFERENCE_PATTERNS_ORDER_TAG_PULSE:
    default:
        if (self->order.as.pulse > 0U) {
            self->order.as.pulse = (uint16_t)(self->order.as.pulse - 1U);
        } else {
            self->order.tag = REFERENCE_PATTERNS_ORDER_TAG_HOLD;
        }
        break;
    }
    return self->open;
}

double reference_patterns_advanced(reference_patterns_valve_t *valve)
{
    const double open = reference_patterns_valve_advance(valve);
    if (valve->last.is_some) {
        valve->last.value = (uint16_t)((uint32_t)valve->last.value + 3U);
    }
    if (valve->order.tag == REFERENCE_PATTERNS_ORDER_TAG_PULSE) {
        uint16_t result_choice = 0U;
        if (valve->last.is_some) {
            result_choice = valve->last.value;
        }
        return open + (double)valve->order.as.pulse + (double)result_choice;
    } else {
        return open;
    }
}

/* reference_patterns.h */

/** Fields of the variant Open of Order. */
typedef struct {
    double to;
    double ramp[2];
} order_open_t;

/** Which variant of `Order`. */
typedef enum {
    REFERENCE_PATTERNS_ORDER_TAG_HOLD = 0,
    REFERENCE_PATTERNS_ORDER_TAG_OPEN = 1,
    REFERENCE_PATTERNS_ORDER_TAG_PULSE = 2
} reference_patterns_order_tag_t;

/** Commands of a valve. */
typedef struct {
    /** Which variant it is. */
    reference_patterns_order_tag_t tag;
    /** What it holds. */
    union {
        order_open_t open;
        uint16_t pulse;
    } as;
} reference_patterns_order_t;

/** A valve. */
typedef struct {
    reference_patterns_order_t order;
    option_u16_t last;
    double open;
} reference_patterns_valve_t;
